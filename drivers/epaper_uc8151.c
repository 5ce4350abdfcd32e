#include "epaper_chip.h"

#include <string.h>

/* Bits of color tell it, over black and white; white ones are ones. */
#define SETUP(mode, meaning)                                             \
    5, 0x01, 0x03, 0x00, 0x2B, 0x2B,     /* supplies of its own, 11 V */ \
        4, 0x06, 0x17, 0x17, 0x17,       /* boosters */                  \
        1, 0x04, PEL_EPAPER_WAIT,        /* power on */                  \
        2, 0x00, mode, 2, 0x50, meaning, /* with the border, interval */ \
        0

static const uint8_t setup[] = {SETUP(0x1F, 0x97)};
static const uint8_t setup_color[] = {SETUP(0x0F, 0x57)};
static const uint8_t refresh[] = {1, 0x12, 0};

static void size(const struct pel_epaper *paper, uint8_t *list)
{
    const uint8_t set[] = {4,
                           0x61,
                           (uint8_t)((paper->width + 7) & ~7),
                           (uint8_t)(paper->height >> 8),
                           (uint8_t)paper->height,
                           0};
    memcpy(list, set, sizeof set);
}

const struct pel_epaper_chip pel_epaper_uc8151 = {
    PEL_EPAPER_UC(setup, setup_color),
    .size = size,
    .refresh = {refresh, refresh, refresh},
    .width = 160,
    .height = 296,
};
