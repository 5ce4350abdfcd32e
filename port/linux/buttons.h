/* Buttons and rotary encoders at GPIO lines of a Linux machine, through
 * libgpiod, as events. They are named in a text:
 *
 *     gpiochip0:5=left,6=right,13=enter,17/27=wheel
 *
 * the chip or its label, then lines and what they do: by number, or by name,
 * which finds its chip itself (GPIO5=left). A line is a key, two lines A/B are
 * an encoder that turns the wheel, or `wheel-x`. Words among them hold for all
 * lines:
 *
 *     pull-up       each closes to ground (without a word)
 *     pull-down     each closes to 3.3 V
 *     floating      each closes to ground, and the board has the resistors
 *     debounce=5    ms that a level must hold
 *     states=4      of an encoder, from detent to detent: 4 or 2
 *     closed        the contacts of encoders are closed at a detent, not open
 */
#ifndef PEL_PORT_LINUX_BUTTONS_H
#define PEL_PORT_LINUX_BUTTONS_H

#include "../../drivers/input_button.h"
#include "../../drivers/input_encoder.h"
#include "gpio.h"

PEL_BEGIN_DECLS

enum { PEL_BUTTONS_TEXT = 512 };

/* What is at a line: a button; or an encoder, and its B is the next line. */
struct pel_buttons_part {
    struct pel_button button;
    struct pel_encoder encoder;
    bool is_encoder, is_b, is_x;
};

struct pel_buttons {
    char text[PEL_BUTTONS_TEXT]; /* cut into the words that request points to */
    struct pel_gpio_request request;
    struct pel_gpio gpio;
    char label[64]; /* of the chip, which may come back by another name */
    struct pel_buttons_part parts[PEL_GPIO_MOST];
    uint32_t active;   /* bit i: line i, as seen last; of encoders that rest
                          closed, whether it is open */
    uint32_t closed;   /* bit i: line i is such an encoder's */
    uint32_t encoders; /* bit i: line i is one's */
    bool open;         /* false too while the chip is away */
    uint16_t losses;   /* of the queue, as seen last */
};

/* Reads the text, and no more. EINVAL with a message when it is wrong. */
int pel_buttons_parse(struct pel_buttons *buttons, const char *text,
                      struct pel_message *message);

/* Takes the lines. 0 or an errno, with a message, as of pel_gpio_open. */
int pel_buttons_open(struct pel_buttons *buttons, struct pel_message *message);
void pel_buttons_close(struct pel_buttons *buttons);

/* Pushes what happened, and after a loss what is held; times are ms of
 * CLOCK_MONOTONIC. Returns the ms after which it is to be called again though
 * no edge came, or -1. When the chip is gone the lines are closed and all is
 * released. */
int pel_buttons_read(struct pel_buttons *buttons,
                     struct pel_input_queue *queue);

PEL_END_DECLS
#endif
