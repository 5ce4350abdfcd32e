/* A paint of one's own: a checkerboard, with its two colors beside it. The
 * picture goes to standard output as PPM.
 *
 *     cc -Iinclude examples/user_paint.c build/libpel.a -o user_paint */
#include <stdio.h>

#include <pel/pel.h>

struct checkers {
    struct pel_color_paint base; /* first, so that one points to the other */
    pel_color even, odd;
    int32_t size; /* px, a power of two */
};

/* A function of x and y alone: pixels may be filled in any order. */
static void checkers_colors(const struct pel_color_paint *paint, int32_t x,
                            int32_t y, int32_t n, pel_color *colors)
{
    const struct checkers *p = (const struct checkers *)paint;
    for (; n > 0; n--, x++)
        *colors++ = (x ^ y) & p->size ? p->odd : p->even;
}

int main(void)
{
    static uint8_t pixels[200 * 200 * 3]; /* R, G, B, as in PPM */
    static const struct checkers checkers = {
        PEL_COLOR_PAINT(checkers_colors, false), PEL_RGB(255, 96, 0),
        PEL_RGBA(0, 64, 128, 160), 8};
    static const struct pel_rect all = {0, 0, 200, 200};
    const struct pel_point center = PEL_AT(100, 100);
    struct pel_surface surface;
    if (pel_surface_init(&surface, &pel_bgr888, pixels, sizeof pixels, &all) !=
        PEL_OK)
        return 1;
    pel_clear(&surface, PEL_RGB(255, 255, 255));
    pel_circle(&surface, center, PEL_PX(80), &checkers.base.paint);
    printf("P6 200 200 255\n");
    fwrite(pixels, 1, sizeof pixels, stdout);
    return 0;
}
