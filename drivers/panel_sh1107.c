#include "panel_chip.h"

/* Memory lies across the glass: its pages are 8 of the chip's 128 segments, its
 * columns are the lines that are scanned. So the display offset, which is one
 * of lines, shifts columns, and glass of 64 columns is wired to those in the
 * middle. */
#define SETUP(lines, offset)                  \
    0xAE,             /* off */               \
        0xD5, 0x51,   /* clock */             \
        0xA8, lines,  /* lines */             \
        0xD3, offset, /* shift of lines */    \
        0xDC, 0x00,   /* from line 0 */       \
        0x20,         /* page by page */      \
        0xAD, 0x8A,   /* supply of its own */ \
        0x81, 0x4F,   /* contrast */          \
        0xD9, 0x22,   /* precharge */         \
        0xDB, 0x35,   /* VCOM */              \
        0xA4,         /* shows memory */      \
        0xAF          /* on */

static const uint8_t setup[] = {20, SETUP(0x3F, 0x60), 0};
static const uint8_t setup_128[] = {20, SETUP(0x7F, 0x00), 0};

#define SH1107                                                            \
    PEL_PANEL_MONO,                                                       \
        .turn = {{0xA0, 0xC0}, {0xA1, 0xC8}, {0xA1, 0xC8}, {0xA0, 0xC0}}, \
        .height = 128

const struct pel_panel_chip pel_panel_sh1107 = {
    SH1107, PEL_PANEL_UPRIGHT, .setup = setup, .width = 64, .columns = 64,
};

const struct pel_panel_chip pel_panel_sh1107_turned = {
    SH1107, PEL_PANEL_TURNED, .setup = setup, .width = 64, .columns = 64,
};

const struct pel_panel_chip pel_panel_sh1107_128 = {
    SH1107, PEL_PANEL_UPRIGHT, .setup = setup_128, .width = 128, .columns = 128,
};

const struct pel_panel_chip pel_panel_sh1107_128_turned = {
    SH1107, PEL_PANEL_TURNED, .setup = setup_128, .width = 128, .columns = 128,
};
