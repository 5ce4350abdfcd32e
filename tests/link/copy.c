/* Copies of all kinds from a surface that is checked, and scrolling. */
#include "screen.h"

static const struct pel_surface screen = SCREEN(pel_rgb565_le);

int main(void)
{
    static uint8_t texels[16 * 16 * 3];
    static const struct pel_rect area = {3, 5, 40, 60};
    struct pel_surface picture;
    if (pel_surface_init(&picture, &pel_rgb888, texels, sizeof texels,
                         &(struct pel_rect){0, 0, 16, 16}) != PEL_OK)
        return 1;
    const struct pel_copy_part part = {&picture, {2, 2, 16, 16}, 20, 30};
    const struct pel_copy_part same = {&screen, {2, 2, 3, 2}, 20, 30};
    pel_copy(&screen, &part);
    pel_copy(&screen, &same);
    pel_copy_keyed(&screen, &part, PEL_RGB(255, 0, 0));
    pel_copy_alpha(&screen, &part, 77);
    return pel_scroll(&screen, &area, 3, -2).n != 2;
}
