/* Shows a picture asset through its surface, as PPM on standard output; built
 * with each asset, for FORMAT, by test_asset_import.sh. Before that, what the
 * asset's check must refuse is tried, that no draw call writes to the pixels,
 * and that the contrast is that of the surface. */
#include <stdio.h>

#include "core/asset/image_asset.h"
#include "core/pel.h"

extern const struct pel_image_asset asset;
extern const struct pel_palette asset_palette; /* of some */

static int refuses(const struct pel_image_asset *image,
                   const struct pel_format *format, enum pel_status expected)
{
    struct pel_surface surface;
    enum pel_status got = pel_image_asset_surface(&surface, image, format);
    if (got != expected)
        fprintf(stderr, "status %d, not %d\n", (int)got, (int)expected);
    return got == expected;
}

static int checks_pass(void)
{
    struct pel_image_asset other = asset;
    const struct pel_format *wrong =
        asset.format == PEL_FORMAT_GRAY8 ? &pel_rgb332 : &pel_gray8;
    int right = refuses(NULL, &FORMAT, PEL_ERROR_NULL) &&
                refuses(&asset, NULL, PEL_ERROR_NULL) &&
                refuses(&asset, wrong, PEL_ERROR_FORMAT);
    other.version++;
    right = right && refuses(&other, &FORMAT, PEL_ERROR_RANGE);
    other = asset;
    other.magic ^= 1;
    right = right && refuses(&other, &FORMAT, PEL_ERROR_RANGE);
    other = asset;
    other.width = 0;
    right = right && refuses(&other, &FORMAT, PEL_ERROR_SIZE);
    other = asset;
    other.stride = -other.stride;
    right = right && refuses(&other, &FORMAT, PEL_ERROR_STRIDE);
    other = asset;
    other.size--;
    right = right && refuses(&other, &FORMAT, PEL_ERROR_STRIDE);
    other = asset;
    other.pixels = NULL;
    return right && refuses(&other, &FORMAT, PEL_ERROR_NULL);
}

static void show(const struct pel_surface *surface)
{
    static pel_color color[32767];
    printf("P6\n%d %d\n255\n", asset.width, asset.height);
    for (int y = 0; y < asset.height; y++) {
        surface->format->load(surface, 0, y, asset.width, color);
        for (int x = 0; x < asset.width; x++) {
            putchar((int)pel_red(color[x]));
            putchar((int)pel_green(color[x]));
            putchar((int)pel_blue(color[x]));
        }
    }
}

int main(void)
{
    struct pel_surface surface;
    if (!checks_pass() ||
        pel_image_asset_surface(&surface, &asset, &FORMAT) != PEL_OK)
        return 1;
    pel_clear(&surface, PEL_RGB(1, 2, 3)); /* would crash in flash */
    show(&surface);
    return 0;
}
