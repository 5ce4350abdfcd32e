#include "epaper_chip.h"

static const uint8_t setup[] = {
    /* clang-format off */
    1, 0x12, PEL_EPAPER_WAIT, /* reset of the registers */
    2, 0x74, 0x54, /* control of the analog block, */
    2, 0x7E, 0x3B, /* and of the digital one */
    2, 0x18, 0x80, /* the chip's own thermometer */
    2, 0x3C, 0x03, /* border */
    0
    /* clang-format on */
};

/* Reads the temperature, takes its waveform, drives, powers down. */
static const uint8_t full[] = {2, 0x22, 0xF7, 1, 0x20, 0};

/* Drives with the waveform that is there. */
static const uint8_t own[] = {2, 0x22, 0xC7, 1, 0x20, 0};

const struct pel_epaper_chip pel_epaper_il3897 = {
    PEL_EPAPER_SSD(setup),
    .refresh = {full, own, own},
    .width = 160,
    .height = 296,
};
