/* Input devices of the Linux kernel, /dev/input/event*, through libevdev:
 * keyboards, mice, tablets and touch screens as events, while they come and go.
 * Keys have the characters of the US layout. A pen's tip is the left button.
 * Of touch pads there are the buttons alone. Fingers come in slots, or as a
 * list in every report (the kernel's protocol A), whose nearest are taken for
 * the same.
 */
#ifndef PEL_PORT_LINUX_EVDEV_H
#define PEL_PORT_LINUX_EVDEV_H

#include "../../drivers/input.h"
#include "../../drivers/linux_io.h"
#include "../../drivers/linux_message.h"
#include "touch_matrix.h"

PEL_BEGIN_DECLS

/* Pushes an event of now without a place. */
static inline void pel_input_push_now(struct pel_input_queue *queue, int kind,
                                      int state, int code)
{
    const struct pel_input event = {pel_linux_milliseconds(),
                                    PEL_CAST(uint8_t, kind),
                                    PEL_CAST(uint8_t, state),
                                    PEL_CAST(uint16_t, code),
                                    0,
                                    0};
    pel_input_push(queue, &event);
}

enum { PEL_EVDEV_FINGERS = 10, PEL_EVDEV_STEPS = 9 /* REL_X to REL_WHEEL */ };

struct libevdev;

struct pel_evdev_finger {
    int16_t x, y; /* px */
    bool down;
};

/* Fingers of the report that comes in, where that is a list. */
struct pel_evdev_list {
    bool is;     /* is it one? */
    bool told;   /* something of it came */
    int n;       /* that are complete */
    bool placed; /* the next one has a place: */
    int x, y;    /* in the kernel's units */
    struct pel_evdev_finger finger[PEL_EVDEV_FINGERS];
};

/* One that is open. */
struct pel_evdev {
    struct libevdev *device; /* NULL: none */
    int number;              /* N of eventN */
    int width, height;       /* px: places are within 0..width - 1 */
    const struct pel_touch_matrix *matrix; /* of fingers; NULL: as told */
    bool keys;          /* tells keys, too: see pel_evdev_open */
    uint8_t places;     /* what its places mean: see evdev.c */
    int slots, fingers; /* slots: 0 where one finger has none */
    uint16_t losses;    /* of the queue, as seen last */
    struct pel_evdev_finger finger[PEL_EVDEV_FINGERS]; /* as told; the first is
                                                          a pointer or a pen,
                                                          too */
    int16_t steps[PEL_EVDEV_STEPS]; /* of the report that comes in, by code */
    struct pel_evdev_list list;
};

/* Opens /dev/input/eventN and tells that it is there, and what is held. Without
 * `keys` those of keyboards are left out, which a program gets that reads a
 * terminal. 0 or an errno, with a message: ENOTSUP when the device has nothing
 * to tell. */
int pel_evdev_open(struct pel_evdev *evdev, int number, bool keys,
                   struct pel_input_queue *queue, struct pel_message *message);

/* Pushes what came, while there is room; after a loss in the kernel
 * PEL_INPUT_LOST; after any loss what is held. When the device is gone all is
 * released and it is closed. */
void pel_evdev_read(struct pel_evdev *evdev, struct pel_input_queue *queue);

/* Takes in a value of EV_ABS of a finger of a list. */
void pel_evdev_list_take(struct pel_evdev_list *list, int code, int value);

/* Which of a list each finger is, by what is nearest; -1: none, it was lifted.
 * What is left over gets numbers that are free. */
void pel_evdev_match(const struct pel_evdev_finger told[PEL_EVDEV_FINGERS],
                     const struct pel_evdev_list *list,
                     int at[PEL_EVDEV_FINGERS]);

/* What to poll. */
int pel_evdev_descriptor(const struct pel_evdev *evdev);

/* Nothing when it is not open. */
void pel_evdev_close(struct pel_evdev *evdev);

/* The kernel's keys, KEY_A and so on, as enum pel_key. */
uint16_t pel_evdev_key(int code);

PEL_END_DECLS
#endif
