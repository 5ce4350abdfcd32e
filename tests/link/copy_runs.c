/* A picture of runs, its pixels those of the screen. */
#include "screen.h"

static const struct pel_surface screen = SCREEN(pel_rgb565_le);

/* A run of 9 pixels, and 3 as they are. */
static const union {
    uint16_t word[6];
    uint32_t alignment;
} words = {{2 * 9 + 1, 0xF800, 2 * 3, 1, 2, 3}};
static const uint16_t rows[2] = {0, 0};

int main(void)
{
    static const struct pel_runs_asset asset = {PEL_RUNS_MAGIC,
                                                PEL_RUNS_VERSION,
                                                PEL_FORMAT_RGB565_LE,
                                                12,
                                                2,
                                                6,
                                                words.word,
                                                rows,
                                                NULL};
    const struct pel_runs_part part = {&asset, &pel_rgb565_le, 20, 30};
    if (pel_runs_asset_check(&asset, &pel_rgb565_le) != PEL_OK)
        return 1;
    pel_copy_runs(&screen, &part, 255);
    return 0;
}
