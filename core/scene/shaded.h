/* Paints that make the colors of a triangle of values at its pixels: a normal,
 * a position, a color. */
#ifndef PEL_SCENE_SHADED_H
#define PEL_SCENE_SHADED_H

#include "../paint/paint_colors.h"
#include "../raster/gouraud.h"
#include "../raster/plane.h"
#include "light.h"

PEL_BEGIN_DECLS

/* The values at vertices and pixels. Positions are in lighting units. */
enum {
    PEL_AT_NORMAL = 0,
    PEL_AT_POSITION = 3,
    PEL_AT_COLOR = 6, /* blue, green, red: steps */
    PEL_VALUES = 9
};

/* The values are linear on screen, over the triangle or, where they are divided
 * (perspective.h), over the pixels at hand. Where there is no surface the
 * colors are in its place. */
struct pel_shaded {
    struct pel_color_paint base;
    const struct pel_color_paint *surface; /* or NULL */
    const struct pel_mesh_lights *lights;
    uint8_t alpha; /* of lit ones; multiplies that of the surface */
    uint8_t span; /* bits of it, for pel_spans_colors: 1..PEL_SHADE_SPAN_MOST */
    struct pel_gouraud colors;
    struct pel_plane plane[PEL_VALUES]; /* of colors only where divided */
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

/* What changes along a row: the normal and the position where light is computed
 * next, and the color at the next pixel. */
struct pel_shaded_row {
    uint64_t at[PEL_AT_COLOR];
    uint32_t own[3];
};

/* Sets it for a run from pixel x on, whose light is computed from `begin` on.
 */
static inline void pel_shaded_start(struct pel_shaded_row *row,
                                    const struct pel_shaded *paint, int32_t x,
                                    int32_t begin, int32_t y)
{
    const struct pel_gouraud *own = &paint->colors;
    for (int k = 0; k < PEL_AT_COLOR; k++)
        row->at[k] = pel_plane_at(&paint->plane[k], begin, y);
    for (int k = 0; k < 3 && !paint->surface; k++)
        row->own[k] = own->at[k] + PEL_CAST(uint32_t, x) * own->dx[k] +
                      PEL_CAST(uint32_t, y) * own->dy[k];
}

/* The light where the row is, which then goes on by 2^bits pixels. */
static inline void pel_shaded_light(struct pel_shaded_row *row,
                                    const struct pel_shaded *paint, int bits,
                                    struct pel_light_sum *sum)
{
    int32_t value[PEL_AT_COLOR];
    PEL_UNROLL
    for (int k = 0; k < PEL_AT_COLOR; k++) {
        value[k] = pel_plane_whole(row->at[k]);
        row->at[k] += bits ? paint->plane[k].dx << bits : paint->plane[k].dx;
    }
    pel_mesh_lights_sum(paint->lights, value + PEL_AT_POSITION,
                        value + PEL_AT_NORMAL, sum);
}

/* A channel of struct pel_gouraud in 1/256 steps: it has a half more, so that
 * its upper 8 bits are rounded. */
static inline uint32_t pel_gouraud_channel(uint32_t v)
{
    return v < 0x800000u ? 0 : (v - 0x7F8000u) >> 16;
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
        if (!paint->surface) {
            own = pel_gouraud_channel(row->own[k]);
            row->own[k] += paint->colors.dx[k];
        }
        lit |= pel_lit_channel(sum, 2 - k, own) << 8 * k;
    }
    return lit;
}
PEL_END_DECLS
#endif
