#include "panel_chip.h"

static const uint8_t setup[] = {
    /* clang-format off */
    1 | PEL_PANEL_PAUSE, 0x01, /* reset, where no line does it */
    1 | PEL_PANEL_PAUSE, 0x11, /* leave sleep */
    4, 0xB1, 0x01, 0x2C, 0x2D, /* frame rates: 63 a second, */
    4, 0xB2, 0x01, 0x2C, 0x2D, /* idle */
    7, 0xB3, 0x01, 0x2C, 0x2D, 0x01, 0x2C, 0x2D, /* or in part */
    2, 0xB4, 0x07, /* each line is driven the other way */
    4, 0xC0, 0xA2, 0x02, 0x84, /* power: voltages of the gamma curve, */
    2, 0xC1, 0xC5, /* of the gates, */
    3, 0xC2, 0x0A, 0x00, /* currents */
    3, 0xC3, 0x8A, 0x2A,
    3, 0xC4, 0x8A, 0xEE,
    2, 0xC5, 0x0E, /* VCOM */
    2, 0x3A, 0x05, /* 16 bits a pixel */
    1, 0x13, /* the whole screen */
    1, 0x29, /* on */
    0
    /* clang-format on */
};

/* 00h takes the parameter of a brightness and does nothing: the chip has none.
 * Glass is wired upside down. */
#define ST7735(n)                                                       \
    PEL_PANEL_DCS(n), PEL_PANEL_565, .setup = setup, .inversion = 0x20, \
                                     .brightness = 0x00
#define BGR .turn = {{0x36, 0xC8}, {0x36, 0xA8}, {0x36, 0x08}, {0x36, 0x68}}
#define RGB .turn = {{0x36, 0xC0}, {0x36, 0xA0}, {0x36, 0x00}, {0x36, 0x60}}

const struct pel_panel_chip pel_panel_st7735 = {
    ST7735(132),
    BGR,
    .height = 162,
};

const struct pel_panel_chip pel_panel_st7735_132x132 = {
    ST7735(132),
    BGR,
    .height = 132,
};

const struct pel_panel_chip pel_panel_st7735_128x160 = {
    ST7735(128),
    RGB,
    .height = 160,
};
