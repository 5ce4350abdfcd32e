/* Prints a text in a font asset as a PGM of 0 and 1, half a pixel or more;
 * built with each asset by test_font_files.sh. The font's check is tried first.
 */
#include <stdio.h>

#include "core/image/glyph_text.h"
#include "core/pel.h"

enum { WIDTH = 640, HEIGHT = 80 };

extern const struct pel_font_asset asset;

int main(int argc, char **argv)
{
    static uint8_t pixels[WIDTH * HEIGHT];
    static const struct pel_flat ink = PEL_FLAT(PEL_RGB(255, 255, 255));
    const struct pel_text_block text = {&asset, argc > 1 ? argv[1] : "", 0, 0};
    const struct pel_text_size size = pel_text_measure(&asset, text.string);
    struct pel_surface surface;
    if (pel_font_asset_check(&asset) != PEL_OK || size.width > WIDTH ||
        size.height > HEIGHT ||
        pel_surface_init(&surface, &pel_gray8, pixels, sizeof pixels,
                         &(struct pel_rect){0, 0, WIDTH, HEIGHT}) != PEL_OK)
        return 1;
    pel_text(&surface, &text, &ink.paint);
    printf("P2\n%d %d\n1\n", size.width, size.height);
    for (int y = 0; y < size.height; y++) {
        for (int x = 0; x < size.width; x++)
            printf("%d", pixels[y * WIDTH + x] >= 128);
        putchar('\n');
    }
    return 0;
}
