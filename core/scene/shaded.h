/* Paints that make the colors of a triangle of values at its pixels: a normal,
 * a position, a color. */
#ifndef PEL_SCENE_SHADED_H
#define PEL_SCENE_SHADED_H

#include "../paint/paint_colors.h"
#include "../raster/gouraud.h"
#include "../raster/plane.h"
#include "light.h"

PEL_BEGIN_DECLS

/* The values at vertices and pixels, behind those that light is computed from
 * (light.h): blue, green, red, in steps. */
enum { PEL_AT_COLOR = PEL_LIGHT_VALUES, PEL_VALUES = PEL_AT_COLOR + 3 };

/* The values are linear on screen, over the triangle or, where they are divided
 * (perspective.h), over the pixels at hand. */
struct pel_shaded {
    struct pel_color_paint base;
    const struct pel_color_paint *surface; /* NULL: the colors are values */
    const struct pel_mesh_lights *lights;
    uint8_t alpha; /* of lit ones; multiplies that of the surface */
    uint8_t span; /* bits of it, for pel_spans_colors: 1..PEL_SHADE_SPAN_MOST */
    union {
        struct pel_gouraud colors; /* of pel_modulated_colors */
        struct pel_plane plane[PEL_VALUES];
    } of;
};

/* Its functions. The surface times the colors, alphas too; the surface, or the
 * colors to 1/256 step, in the light; the same with the light at pixels whose x
 * is a multiple of a span, up to one on either side of the run, and linear
 * between. */
pel_colors_function pel_modulated_colors, pel_lit_colors, pel_spans_colors;

enum { PEL_SHADE_SPAN_MOST = 3 };

/* Gets the colors of the surface. */
static inline void pel_shaded_surface(const struct pel_shaded *paint, int32_t x,
                                      int32_t y, int32_t n, pel_color *out)
{
    if (paint->surface)
        paint->surface->colors(paint->surface, x, y, n, out);
    else
        for (int32_t i = 0; i < n; i++)
            out[i] = UINT32_C(0xFF000000);
}

/* The values along a row: the normal and the position where light is computed
 * next, and the color of the next pixel. */
struct pel_shaded_row {
    uint64_t at[PEL_VALUES];
};

/* Sets it for a run from pixel x on, whose light is computed from `begin` on.
 */
static inline void pel_shaded_start(struct pel_shaded_row *row,
                                    const struct pel_shaded *paint, int32_t x,
                                    int32_t begin, int32_t y)
{
    const int values = paint->surface ? PEL_AT_COLOR : PEL_VALUES;
    for (int k = 0; k < values; k++)
        row->at[k] =
            pel_plane_at(&paint->of.plane[k], k < PEL_AT_COLOR ? begin : x, y);
}

/* The light where the row is, which then goes on by 2^bits pixels. */
static inline void pel_shaded_light(struct pel_shaded_row *row,
                                    const struct pel_shaded *paint, int bits,
                                    struct pel_light_sum *sum)
{
    int32_t value[PEL_LIGHT_VALUES];
    PEL_UNROLL
    for (int k = 0; k < PEL_LIGHT_VALUES; k++) {
        const uint64_t dx = paint->of.plane[k].dx;
        value[k] = pel_plane_whole(row->at[k]);
        row->at[k] += bits ? dx << bits : dx;
    }
    pel_mesh_lights_sum(paint->lights, value, sum);
}

/* The color at the row's next pixel, in 1/256 steps. */
static inline uint32_t pel_shaded_own(uint64_t *at,
                                      const struct pel_plane *plane)
{
    const int32_t own = PEL_CAST(int32_t, (*at + 0x8000u) >> 16);
    *at += plane->dx;
    return PEL_CAST(uint32_t, pel_max(own, 0));
}

/* The color `under` a pixel, or the row's own, in the light; the row's goes on
 * by a pixel. */
static inline pel_color pel_shaded_color(struct pel_shaded_row *row,
                                         const struct pel_shaded *paint,
                                         const struct pel_light_sum *sum,
                                         pel_color under)
{
    pel_color lit = pel_round_div255(pel_alpha(under) * paint->alpha) << 24;
    PEL_UNROLL
    for (int k = 0; k < 3; k++) {
        uint32_t own = (under >> 8 * k & 255) << 8;
        if (!paint->surface)
            own = pel_shaded_own(&row->at[PEL_AT_COLOR + k],
                                 &paint->of.plane[PEL_AT_COLOR + k]);
        lit |= pel_lit_channel(sum, 2 - k, own) << 8 * k;
    }
    return lit;
}
PEL_END_DECLS
#endif
