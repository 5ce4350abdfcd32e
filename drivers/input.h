/* Input: what a user does, as events of one form in a queue, whatever the
 * device: keyboard, button, encoder, mouse, tablet, touch.
 *
 *     static struct pel_input events[16];
 *     static struct pel_input_queue queue = PEL_INPUT_QUEUE(events);
 *
 *     an interrupt, a timer or a driver:  pel_input_push(&queue, &event);
 *     the program:     while (pel_input_pop(&queue, &event)) ...
 *
 * Events come out in the order in which they went in. Nothing is lost silently:
 * where the queue was full stands a PEL_INPUT_LOST. No call allocates. */
#ifndef PEL_DRIVERS_INPUT_H
#define PEL_DRIVERS_INPUT_H

#include <stdbool.h>
#include <stdint.h>

#include <pel/pel.h>

PEL_BEGIN_DECLS

enum pel_input_kind {
    /* One or more events were lost here. What is held down is not known: the
     * program takes all keys, buttons and fingers for released; those that its
     * driver knows to be held come as pressed after it. */
    PEL_INPUT_LOST,
    PEL_INPUT_KEY,    /* a key or a button: code, state */
    PEL_INPUT_BUTTON, /* of a pointer: code 1 left, 2 middle, 3 right, 4...;
                         state */
    PEL_INPUT_MOVE,   /* the pointer went by x, y (mouse) */
    PEL_INPUT_POINT,  /* the pointer is at x, y (tablet) */
    PEL_INPUT_TOUCH,  /* finger `code`, from 0, at x, y; state */
    PEL_INPUT_WHEEL,  /* turned by y notches away from the user or clockwise,
                         x to the right */
    PEL_INPUT_DEVICE  /* a device, numbered by its driver: code; state: DOWN it
                         came; UP it went, and all that it held is released */
};

enum pel_input_state {
    PEL_INPUT_UP,   /* released, lifted */
    PEL_INPUT_DOWN, /* pressed, touched */
    PEL_INPUT_AGAIN /* still held: a key repeats, a finger moves */
};

/* Codes of keys. A key with a character is that character, as it is without
 * shift where the device knows no better: 'a', '1', '-', ' '. */
enum pel_key {
    PEL_KEY_BACKSPACE = 8,
    PEL_KEY_TAB = 9,
    PEL_KEY_ENTER = 13,
    PEL_KEY_ESCAPE = 27,
    PEL_KEY_DELETE = 127,
    PEL_KEY_LEFT = 256,
    PEL_KEY_RIGHT,
    PEL_KEY_UP,
    PEL_KEY_DOWN,
    PEL_KEY_HOME,
    PEL_KEY_END,
    PEL_KEY_PAGE_UP,
    PEL_KEY_PAGE_DOWN,
    PEL_KEY_INSERT,
    PEL_KEY_SHIFT,
    PEL_KEY_CTRL,
    PEL_KEY_ALT,
    PEL_KEY_F1 = 288,      /* F2 is the next, up to F24 */
    PEL_KEY_OTHER = 0x4000 /* and above: the platform's number, added */
};

struct pel_input {
    uint32_t time; /* ms of the driver's clock, which wraps */
    uint8_t kind;  /* enum pel_input_kind */
    uint8_t state; /* enum pel_input_state */
    uint16_t code;
    int16_t x, y; /* px of the display, or steps */
};

/* Single producer, single consumer: on one core an interrupt may push while the
 * program pops. Threads and cores need a lock of their own. */
struct pel_input_queue {
    volatile struct pel_input *events;
    uint16_t size; /* >= 3; holds size - 2 events and a PEL_INPUT_LOST */
    volatile uint16_t first, end; /* end: the first free one */
    volatile uint16_t losses;     /* counted by pel_input_push */
};

/* The initial value of a queue over an array. */
#define PEL_INPUT_QUEUE(array)                                           \
    {                                                                    \
        (array), (uint16_t)(sizeof(array) / sizeof((array)[0])), 0, 0, 0 \
    }

/* False when the event was lost, which the queue will tell. A driver may push a
 * PEL_INPUT_LOST itself. */
bool pel_input_push(struct pel_input_queue *queue,
                    const struct pel_input *event);

/* For drivers: has anything been lost since the last call with this `seen`,
 * which begins as 0? Then what is held has to be told again. */
bool pel_input_lost(const struct pel_input_queue *queue, uint16_t *seen);

/* The oldest event, which leaves the queue. False when there is none. */
bool pel_input_pop(struct pel_input_queue *queue, struct pel_input *event);

/* How many events can be pushed before one is lost. */
int pel_input_room(const struct pel_input_queue *queue);

PEL_END_DECLS
#endif
