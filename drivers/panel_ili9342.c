#include "panel_chip.h"

static const uint8_t setup[] = {
    /* clang-format off */
    1 | PEL_PANEL_PAUSE, 0x01, /* reset, where no line does it */
    4, 0xC8, 0xFF, 0x93, 0x42, /* opens the registers below */
    3, 0xC0, 0x12, 0x12, /* power control 1 */
    2, 0xC1, 0x03, /* power control 2 */
    2, 0xC5, 0xF2, /* VCOM control */
    2, 0xB0, 0xE0, /* pins as they are */
    4, 0xF6, 0x01, 0x00, 0x00, /* pixels from memory */
    2, 0x3A, 0x55, /* 16 bits a pixel */
    4, 0xB6, 0x08, 0x82, 0x1D, /* scan directions, 240 lines */
    PEL_PANEL_BRIGHT, PEL_PANEL_ON,
    0
    /* clang-format on */
};

/* The usual module has BGR glass that shows black where it is not driven. */
const struct pel_panel_chip pel_panel_ili9342 = {
    PEL_PANEL_DCS(320),
    PEL_PANEL_565,
    .setup = setup,
    .height = 240,
    .turn = {{0x36, 0x08}, {0x36, 0x68}, {0x36, 0xC8}, {0x36, 0xA8}},
    .inversion = 0x21,
    .brightness = 0x51,
};
