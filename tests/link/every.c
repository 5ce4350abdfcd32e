/* Every shape with every paint. */
#include "draws.h"
#include "makes.h"

static draw_function *const draws[] = {
    draw_triangle,
    draw_triangle_or_line,
    draw_polygon,
    draw_rectangle,
    draw_line,
    draw_thick_line,
    draw_circle,
    draw_ring,
    draw_sector,
    draw_arc,
    draw_ellipse,
    draw_rounded_rectangle,
    draw_triangle_outline,
    draw_rectangle_outline,
    draw_rounded_rectangle_outline,
    draw_circle_outline,
    draw_ellipse_outline,
    draw_arc_outline,
    draw_polygon_outline,
    draw_text,
};

static make_function *const makes[] = {
    make_flat,    make_flat_alpha,     make_gouraud,  make_linear,
    make_radial,  make_conic,          make_hue,      make_fan,
    make_nearest, make_nearest_colors, make_bilinear, make_dither,
    make_user,
};

int main(void)
{
    for (unsigned i = 0; i < sizeof makes / sizeof *makes; i++) {
        const struct pel_paint *paint = makes[i]();
        for (unsigned k = 0; k < sizeof draws / sizeof *draws; k++)
            draws[k](paint);
    }
    return 0;
}
