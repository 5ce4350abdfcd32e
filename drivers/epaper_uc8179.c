#include "epaper_chip.h"

#include <string.h>

/* Bits of color tell it, over black and white; white ones are ones. */
#define SETUP(mode, meaning)                                                   \
    5, 0x01, 0x07, 0x07, 0x3F, 0x3F,           /* supplies of its own, 15 V */ \
        1, 0x04, PEL_EPAPER_WAIT,              /* power on */                  \
        2, 0x00, mode, 3, 0x50, meaning, 0x07, /* with the border */           \
        0

static const uint8_t setup[] = {SETUP(0x1F, 0x21)};
static const uint8_t setup_color[] = {SETUP(0x0F, 0x11)};

/* Temperatures that are told choose shorter waveforms than the thermometer. */
static const uint8_t full[] = {2, 0xE0, 0x00, 1, 0x12, 0};
static const uint8_t fast[] = {2, 0xE0, 0x02, 2, 0xE5, 0x5A, 1, 0x12, 0};
static const uint8_t partial[] = {2, 0xE0, 0x02, 2, 0xE5, 0x6E, 1, 0x12, 0};
static const uint8_t grays[] = {2, 0xE0, 0x02, 2, 0xE5, 0x5F, 1, 0x12, 0};

static void size(const struct pel_epaper *paper, uint8_t *list)
{
    const int32_t width = (paper->width + 7) & ~7;
    const uint8_t set[] = {5,
                           0x61,
                           (uint8_t)(width >> 8),
                           (uint8_t)width,
                           (uint8_t)(paper->height >> 8),
                           (uint8_t)paper->height,
                           0};
    memcpy(list, set, sizeof set);
}

const struct pel_epaper_chip pel_epaper_uc8179_gray2 = {
    PEL_EPAPER_UC_GRAYS(setup),
    .size = size,
    .refresh = {grays},
    .width = 800,
    .height = 600,
};

const struct pel_epaper_chip pel_epaper_uc8179 = {
    PEL_EPAPER_UC(setup, setup_color),
    .size = size,
    .refresh = {full, fast, partial},
    .width = 800,
    .height = 600,
};
