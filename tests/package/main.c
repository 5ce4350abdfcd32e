#include <stdio.h>
#include <pel/pel.h>

/* The same picture by every way to use Pel. */
int main(void)
{
    static uint32_t pixels[16 * 16];
    const struct pel_rect all = {0, 0, 16, 16};
    const struct pel_flat red = PEL_FLAT(PEL_RGB(255, 0, 0));
    const struct pel_point center = PEL_AT(8, 8);
    struct pel_surface s;
    if (pel_surface_init(&s, &pel_xrgb8888, pixels, sizeof pixels, &all))
        return 1;
    pel_circle(&s, center, PEL_PX(7), &red.paint);
    return fwrite(pixels, sizeof pixels, 1, stdout) != 1;
}
