/* What guest_input.sh does to the kiosk: a key, and a finger on the last card;
 * before examples/kiosk_events.h. */
#define EXAMPLES_KIOSK_EVENTS_H

#define PANEL_WORDS (480 * 320 * 2)
#define PANEL_EVENTS                                             \
    {100, PEL_INPUT_KEY, PEL_INPUT_DOWN, PEL_KEY_RIGHT, 0, 0},   \
        {200, PEL_INPUT_TOUCH, PEL_INPUT_DOWN, 1, 400, 160},     \
    {                                                            \
        300, PEL_INPUT_KEY, PEL_INPUT_DOWN, PEL_KEY_ESCAPE, 0, 0 \
    }
