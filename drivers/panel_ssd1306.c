#include "panel_chip.h"

/* What all modules have, with the supply made on the chip. */
#define SETUP                               \
    0xAE,           /* off */               \
        0xD3, 0x00, /* no shift of rows */  \
        0x40,       /* from row 0 */        \
        0x8D, 0x14, /* supply of its own */ \
        0x20, 0x02, /* page by page */      \
        0x81, 0xCF, /* contrast */          \
        0xD9, 0xF1, /* precharge */         \
        0xDB, 0x40, /* VCOMH */             \
        0xA4,       /* shows memory */      \
        0x2E,       /* no scrolling */      \
        0xAF        /* on */

static const uint8_t setup[] = {17, SETUP, 0};

/* 32 rows, each wired to the next line. */
static const uint8_t setup_32[] = {21, 0xA8, 0x1F, 0xDA, 0x02, SETUP, 0};

const struct pel_panel_chip pel_panel_ssd1306 = {
    PEL_PANEL_OLED, PEL_PANEL_UPRIGHT, .setup = setup,
    .height = 64,   .columns = 128,
};

const struct pel_panel_chip pel_panel_ssd1306_turned = {
    PEL_PANEL_OLED, PEL_PANEL_TURNED, .setup = setup,
    .height = 64,   .columns = 128,
};

const struct pel_panel_chip pel_panel_ssd1306_32 = {
    PEL_PANEL_OLED, PEL_PANEL_UPRIGHT, .setup = setup_32,
    .height = 32,   .columns = 128,
};

const struct pel_panel_chip pel_panel_ssd1306_32_turned = {
    PEL_PANEL_OLED, PEL_PANEL_TURNED, .setup = setup_32,
    .height = 32,   .columns = 128,
};
