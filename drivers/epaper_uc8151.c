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
static const uint8_t setup_grays[] = {SETUP(0x3F, 0x97)}; /* own waveform */
static const uint8_t refresh[] = {1, 0x12, 0};

/* Levels of the sources in two groups of four phases, black 01 and white 10:
 * black for as long as white takes, white, and as much black again as is
 * wanted, from whatever the glass shows. The same amount of white, before all,
 * leaves no charge in the glass. */
#define LEVELS_0 0xA9, 0x95 /* black */
#define LEVELS_1 0xA1, 0x94
#define LEVELS_2 0x81, 0x90
#define LEVELS_3 0x01, 0x80

/* Frames of black: light grey, so many more for dark grey, and for black. */
enum { LIGHT = 3, DARK = 5, BLACK = 12, SWING = LIGHT + DARK + BLACK };

/* Seven groups, each of four levels, their frames of 20 ms, and how often. */
#define GROUPS(first, second)                                                  \
    first, LIGHT, DARK, BLACK, SWING, 1, second, SWING, LIGHT, DARK, BLACK, 1, \
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,   \
        0, 0, 0, 0, 0, 0, 0
#define REGISTER(levels) GROUPS(levels)

/* Of the common electrode, which has two bytes more; of what both planes have
 * as white, as the second alone, as the first alone, and as black. */
const uint8_t pel_epaper_uc8151_grays[] = {
    /* clang-format off */
    45, 0x20, GROUPS(0, 0), 0, 0,
    43, 0x21, REGISTER(LEVELS_3),
    43, 0x22, REGISTER(LEVELS_2),
    43, 0x23, REGISTER(LEVELS_1),
    43, 0x24, REGISTER(LEVELS_0),
    0
    /* clang-format on */
};

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

const struct pel_epaper_chip pel_epaper_uc8151_gray2 = {
    PEL_EPAPER_UC_GRAYS(setup_grays),
    .size = size,
    .refresh = {refresh},
    .width = 160,
    .height = 296,
};

const struct pel_epaper_chip pel_epaper_uc8151 = {
    PEL_EPAPER_UC(setup, setup_color),
    .size = size,
    .refresh = {refresh, refresh, refresh},
    .width = 160,
    .height = 296,
};
