#include "panel_chip.h"

static const uint8_t setup[] = {
    /* clang-format off */
    1 | PEL_PANEL_PAUSE, 0x01, /* reset, where no line does it */
    2, 0xF0, 0xC3, /* opens the registers below */
    2, 0xF0, 0x96,
    2, 0x3A, 0x55, /* 16 bits a pixel */
    2, 0xB4, 0x01, /* each dot is driven the other way */
    4, 0xB6, 0x80, 0x02, 0x3B, /* scan directions, 480 lines */
    9, 0xE8, 0x40, 0x8A, 0x00, 0x00, 0x29, 0x19, 0xA5, 0x33, /* row times */
    2, 0xC1, 0x06, /* voltages */
    2, 0xC2, 0xA7, /* currents */
    2, 0xC5, 0x18, /* VCOM */
    2, 0xF0, 0x3C, /* closes them */
    2, 0xF0, 0x69,
    PEL_PANEL_BRIGHT, PEL_PANEL_ON,
    0
    /* clang-format on */
};

/* The usual module has BGR glass, with its columns from right to left. */
const struct pel_panel_chip pel_panel_st7796 = {
    PEL_PANEL_DCS(320),
    PEL_PANEL_565,
    .setup = setup,
    .height = 480,
    .turn = {{0x36, 0x48}, {0x36, 0x28}, {0x36, 0x88}, {0x36, 0xE8}},
    .inversion = 0x20,
    .brightness = 0x51,
};
