#include "panel_chip.h"

/* Commands of MIPI's Display Command Set. */
const uint8_t pel_panel_dcs_wake[] = {
    /* clang-format off */
    1 | PEL_PANEL_PAUSE, 0x11, /* leave sleep */
    1, 0x29, /* display on */
    0
    /* clang-format on */
};

const uint8_t pel_panel_dcs_sleep[] = {
    /* clang-format off */
    1, 0x28, /* display off */
    1 | PEL_PANEL_PAUSE, 0x10, /* sleep */
    0
    /* clang-format on */
};
