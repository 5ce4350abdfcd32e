#include "epaper_chip.h"

/* Modules wire its sources from the ninth on. */
static const uint8_t setup[] = {
    /* clang-format off */
    1, 0x12, PEL_EPAPER_WAIT, /* reset of the registers */
    2, 0x18, 0x80, /* the chip's own thermometer */
    3, 0x21, 0x00, 0x80, /* memory as it is, sources from the ninth on */
    0
    /* clang-format on */
};

static const uint8_t setup_1681[] = {
    /* clang-format off */
    1, 0x12, PEL_EPAPER_WAIT, /* reset of the registers */
    2, 0x18, 0x80, /* the chip's own thermometer */
    0
    /* clang-format on */
};

/* White border; reads the temperature, takes its waveform, drives, powers down.
 */
static const uint8_t full[] = {2, 0x3C, 0x05, 2, 0x22, 0xF7, 1, 0x20, 0};

/* That of 100 degrees is the shortest waveform. */
static const uint8_t fast[] = {
    /* clang-format off */
    2, 0x3C, 0x05, /* white border */
    3, 0x1A, 0x64, 0x00, /* temperature */
    2, 0x22, 0x91,
    1, 0x20, PEL_EPAPER_WAIT, /* takes its waveform */
    2, 0x22, 0xC7,
    1, 0x20, /* drives, powers down */
    0
    /* clang-format on */
};

/* The border stays; the second display mode compares the planes. */
static const uint8_t partial[] = {2, 0x3C, 0x80, 2, 0x22, 0xFF, 1, 0x20, 0};

/* The module's waveform of four greys is that of 90 degrees. */
static const uint8_t grays[] = {
    /* clang-format off */
    2, 0x3C, 0x05, /* white border */
    3, 0x1A, 0x5A, 0x00, /* temperature */
    2, 0x22, 0x91,
    1, 0x20, PEL_EPAPER_WAIT, /* takes its waveform */
    2, 0x22, 0xC7,
    1, 0x20, /* drives, powers down */
    0
    /* clang-format on */
};

const struct pel_epaper_chip pel_epaper_ssd1680_gray2 = {
    PEL_EPAPER_SSD_GRAYS(setup),
    .refresh = {grays},
    .width = 160,
    .height = 296,
};

const struct pel_epaper_chip pel_epaper_ssd1680 = {
    PEL_EPAPER_SSD(setup),
    .refresh = {full, fast, partial},
    .width = 160,
    .height = 296,
};

const struct pel_epaper_chip pel_epaper_ssd1681 = {
    PEL_EPAPER_SSD(setup_1681),
    .refresh = {full, fast, partial},
    .width = 200,
    .height = 200,
};
