#include "panel_chip.h"

static const uint8_t setup[] = {
    /* clang-format off */
    15, /* bytes, which may all come at once */
    0xAE, /* off */
    0xD5, 0x80, /* clock */
    0xD3, 0x00, /* no shift of rows */
    0x40, /* from row 0 */
    0xAD, 0x8B, /* supply of its own */
    0x81, 0x80, /* contrast */
    0xD9, 0x1F, /* precharge */
    0xDB, 0x40, /* VCOM */
    0xAF, /* on */
    0
    /* clang-format on */
};

/* Memory is 132 columns wide; glass of 128 is wired to those in the middle. */
const struct pel_panel_chip pel_panel_sh1106 = {
    PEL_PANEL_OLED, PEL_PANEL_UPRIGHT, .setup = setup,
    .height = 64,   .columns = 132,    .left = 2,
};

const struct pel_panel_chip pel_panel_sh1106_turned = {
    PEL_PANEL_OLED, PEL_PANEL_TURNED, .setup = setup,
    .height = 64,   .columns = 132,   .left = 2,
};
