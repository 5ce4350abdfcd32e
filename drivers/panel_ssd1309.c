#include "panel_chip.h"

/* An SSD1306 whose supply the module brings. */
static const uint8_t setup[] = {
    /* clang-format off */
    20, /* bytes, which may all come at once */
    0xFD, 0x12, /* opens the commands */
    0xAE, /* off */
    0xD5, 0xA0, /* clock */
    0xA8, 0x3F, /* 64 rows */
    0xD3, 0x00, /* no shift of rows */
    0x40, /* from row 0 */
    0x20, 0x02, /* page by page */
    0x81, 0xCF, /* contrast */
    0xD9, 0x82, /* precharge */
    0xDB, 0x34, /* VCOMH */
    0xA4, /* shows memory */
    0xAF, /* on */
    0
    /* clang-format on */
};

const struct pel_panel_chip pel_panel_ssd1309 = {
    PEL_PANEL_OLED, PEL_PANEL_UPRIGHT, .setup = setup,
    .height = 64,   .columns = 128,
};

const struct pel_panel_chip pel_panel_ssd1309_turned = {
    PEL_PANEL_OLED, PEL_PANEL_TURNED, .setup = setup,
    .height = 64,   .columns = 128,
};
