#include "panel_chip.h"

static const uint8_t setup[] = {
    /* clang-format off */
    9, /* bytes, which may all come at once */
    0xA2, /* bias 1/9 */
    0xF8, 0x00, /* booster: four times */
    0x27, /* ratio of the regulator's resistors */
    0x81, 0x16, /* contrast */
    0x2F, /* supply of its own */
    0x40, /* from row 0 */
    0xAF, /* on */
    0
    /* clang-format on */
};

/* Memory is 132 columns wide, which the usual glass has from the last one on,
 * back to the fifth. */
#define ST7565                                                      \
    PEL_PANEL_MONO,                                                 \
        .setup = setup, .width = 128, .height = 64, .columns = 132, \
        .shift = 2,                                                 \
        .turn = {{0xA1, 0xC0}, {0xA0, 0xC8}, {0xA0, 0xC8}, {0xA1, 0xC0}}

const struct pel_panel_chip pel_panel_st7565 = {
    ST7565,
    PEL_PANEL_UPRIGHT,
};

const struct pel_panel_chip pel_panel_st7565_turned = {
    ST7565,
    PEL_PANEL_TURNED,
};
