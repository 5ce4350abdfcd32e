/* Shows a picture asset of runs, of FORMAT, drawn in bands of a few rows, as
 * PPM on standard output; built with each asset by test_asset_import.sh. */
#include <stdio.h>

#include "core/pel.h"

extern const struct pel_runs_asset asset;
extern const struct pel_palette asset_palette; /* of some */

int main(void)
{
    enum { ROWS = 4 };
    static pel_color memory[ROWS * 256];
    const struct pel_runs_part part = {&asset, &FORMAT, 0, 0};
    if (pel_runs_asset_check(&asset, &FORMAT) != PEL_OK)
        return 1;
    printf("P6\n%d %d\n255\n", asset.width, asset.height);
    for (int y = 0; y < asset.height; y += ROWS) {
        const struct pel_rect rows = {0, y, asset.width, y + ROWS};
        struct pel_surface band;
        if (pel_surface_init(&band, &pel_rgb888, memory, sizeof memory,
                             &rows) != PEL_OK)
            return 1;
        pel_copy_runs(&band, &part, 255);
        for (int i = 0; i < ROWS && y + i < asset.height; i++)
            for (int x = 0; x < asset.width; x++) {
                const uint8_t *bgr = pel_surface_line(&band, y + i) + 3 * x;
                printf("%c%c%c", bgr[2], bgr[1], bgr[0]);
            }
    }
    return 0;
}
