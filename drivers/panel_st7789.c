#include "panel_chip.h"

static const uint8_t setup[] = {
    /* clang-format off */
    1 | PEL_PANEL_PAUSE, 0x01, /* reset, where no line does it */
    2, 0x3A, 0x55, /* 16 bits a pixel */
    PEL_PANEL_BRIGHT, PEL_PANEL_ON,
    0
    /* clang-format on */
};

const struct pel_panel_chip pel_panel_st7789 = {
    PEL_PANEL_DCS(240),
    PEL_PANEL_565,
    .setup = setup,
    .height = 320,
    .turn = {{0x36, 0x00}, {0x36, 0x60}, {0x36, 0xC0}, {0x36, 0xA0}},
    .inversion = 0x21,
    .brightness = 0x51,
};
