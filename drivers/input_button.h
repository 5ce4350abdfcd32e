/* Buttons that bounce. A button's contacts open and close for some milliseconds
 * whenever it is pressed or released; what counts is the level that has held.
 *
 *     static struct pel_button enter = {.code = PEL_KEY_ENTER, .hold = 5};
 *     static uint16_t seen;
 *
 *     every millisecond or so, or at an edge and again `hold` later:
 *         if (pel_input_lost(&queue, &seen))
 *             enter.pressed = false;
 *         if (pel_button_update(&enter, pin_is_low(), time, &event))
 *             pel_input_push(&queue, &event);
 */
#ifndef PEL_DRIVERS_INPUT_BUTTON_H
#define PEL_DRIVERS_INPUT_BUTTON_H

#include "input.h"

PEL_BEGIN_DECLS

struct pel_button {
    uint16_t code;  /* of its key */
    uint16_t hold;  /* ms that a level must hold to count; 0: at once */
    bool pressed;   /* as told last; false after a loss tells it again */
    bool level;     /* as seen last */
    uint32_t since; /* when that level was first seen */
};

/* Tells the level (true: pressed) that the button has at `time`, which goes
 * forward by less than 2^31 ms between two calls. True with the event, when the
 * button is pressed or released; its time is that of the level's first sight.
 */
bool pel_button_update(struct pel_button *button, bool level, uint32_t time,
                       struct pel_input *event);

PEL_END_DECLS
#endif
