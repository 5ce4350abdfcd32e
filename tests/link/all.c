/* Every shape with every paint, and a surface that is checked. */
#include "screen.h"

static const struct pel_point v[5] = {PEL_AT(32, -5), PEL_AT(51, 60),
                                      PEL_AT(2, 20), PEL_AT(69, 20),
                                      PEL_AT(12, 60)};

static enum pel_status draw(const struct pel_surface *screen,
                            const struct pel_paint *paint)
{
    static uint32_t scratch[64];
    const struct pel_polygon_shape star = {v, 5, PEL_NON_ZERO};
    pel_triangle(screen, v, paint);
    pel_triangle_or_line(screen, v, paint);
    pel_circle(screen, v[0], PEL_PX(30), paint);
    pel_rectangle(screen, v[2], v[1], paint);
    pel_line(screen, v[0], v[3], paint);
    return pel_polygon(screen, &star, paint, scratch, sizeof scratch);
}

int main(void)
{
    static const struct pel_flat red = PEL_FLAT(PEL_RGB(255, 0, 0));
    static const struct pel_flat glass = PEL_FLAT(PEL_RGBA(0, 0, 255, 128));
    static const pel_color colors[3] = {PEL_RGBA(255, 0, 0, 255),
                                        PEL_RGBA(0, 255, 0, 128),
                                        PEL_RGBA(0, 0, 255, 0)};
    struct pel_surface screen;
    if (pel_surface_init(&screen, &pel_rgb565_le, pixels, SCREEN_SIDE,
                         SCREEN_SIDE))
        return 1;
    pel_clear(&screen, PEL_RGB(255, 255, 255));
    pel_triangle_gouraud(&screen, v, colors);
    return draw(&screen, &red.paint) || draw(&screen, &glass.paint);
}
