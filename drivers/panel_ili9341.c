#include "panel_chip.h"

static const uint8_t setup[] = {
    /* clang-format off */
    1 | PEL_PANEL_PAUSE, 0x01, /* reset, where no line does it */
    4, 0xCF, 0x00, 0xC1, 0x30, /* power control B */
    5, 0xED, 0x64, 0x03, 0x12, 0x81, /* power-on sequence */
    4, 0xE8, 0x85, 0x00, 0x78, /* driver timing A */
    6, 0xCB, 0x39, 0x2C, 0x00, 0x34, 0x02, /* power control A */
    2, 0xF7, 0x20, /* pump ratio */
    3, 0xEA, 0x00, 0x00, /* driver timing B */
    2, 0xC0, 0x23, /* power control 1 */
    2, 0xC1, 0x10, /* power control 2 */
    3, 0xC5, 0x3E, 0x28, /* VCOM control 1 */
    2, 0xC7, 0x86, /* VCOM control 2 */
    2, 0x3A, 0x55, /* 16 bits a pixel */
    3, 0xB1, 0x00, 0x18, /* 79 frames a second */
    4, 0xB6, 0x08, 0x82, 0x27, /* scan directions, 320 lines */
    2, 0x26, 0x01, /* gamma curve */
    PEL_PANEL_BRIGHT, PEL_PANEL_ON,
    0
    /* clang-format on */
};

/* The usual module has BGR glass, with its columns from right to left. */
const struct pel_panel_chip pel_panel_ili9341 = {
    PEL_PANEL_DCS(240),
    PEL_PANEL_565,
    .setup = setup,
    .height = 320,
    .turn = {{0x36, 0x48}, {0x36, 0x28}, {0x36, 0x88}, {0x36, 0xE8}},
    .inversion = 0x20,
    .brightness = 0x51,
};
