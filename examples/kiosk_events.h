/* What a user does where there is none, for the picture: an event each after so
 * many ms; and words of 16 bits of the screen. */
#ifndef EXAMPLES_KIOSK_EVENTS_H
#define EXAMPLES_KIOSK_EVENTS_H

#define PANEL_WORDS (480 * 320 * 2)
#define PANEL_EVENTS                                               \
    {100, PEL_INPUT_KEY, PEL_INPUT_DOWN, PEL_KEY_LEFT, 0, 0},      \
        {200, PEL_INPUT_TOUCH, PEL_INPUT_DOWN, 0, 240, 160},       \
        {300, PEL_INPUT_KEY, PEL_INPUT_DOWN, PEL_KEY_ENTER, 0, 0}, \
    {                                                              \
        2500, PEL_INPUT_KEY, PEL_INPUT_DOWN, PEL_KEY_ESCAPE, 0, 0  \
    }

#endif
