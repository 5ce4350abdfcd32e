#include "panel_chip.h"

static const uint8_t setup[] = {
    /* clang-format off */
    1 | PEL_PANEL_PAUSE, 0x01, /* reset, where no line does it */
    3, 0xC0, 0x17, 0x15, /* power control 1 */
    2, 0xC1, 0x41, /* power control 2 */
    4, 0xC5, 0x00, 0x12, 0x80, /* VCOM control */
    2, 0x3A, 0x66, /* 18 bits a pixel, the only colours that SPI carries */
    2, 0xB0, 0x00, /* pins as they are */
    2, 0xB1, 0xA0, /* 60 frames a second */
    2, 0xB4, 0x02, /* dots beside each other are driven the other way */
    4, 0xB6, 0x02, 0x02, 0x3B, /* scan directions, 480 lines */
    2, 0xE9, 0x00, /* no bits are made of others */
    5, 0xF7, 0xA9, 0x51, 0x2C, 0x82, /* adjustment of the maker's */
    PEL_PANEL_BRIGHT, PEL_PANEL_ON,
    0
    /* clang-format on */
};

/* The usual module has BGR glass, with its columns from right to left. */
const struct pel_panel_chip pel_panel_ili9488 = {
    PEL_PANEL_DCS(320),
    .setup = setup,
    .height = 480,
    .formats = {PEL_FORMAT_BGR888, PEL_FORMAT_BGR888},
    .turn = {{0x36, 0x48}, {0x36, 0x28}, {0x36, 0x88}, {0x36, 0xE8}},
    .inversion = 0x20,
    .brightness = 0x51,
};
