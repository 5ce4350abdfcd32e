/* Phong's light on a triangle: at every pixel, or at the ends of spans and
 * linear between. */
#ifndef PEL_SCENE_PAINT_PHONG_H
#define PEL_SCENE_PAINT_PHONG_H

#include "../paint/paint_colors.h"
#include "../raster/gouraud.h"
#include "../raster/plane.h"
#include "light.h"

PEL_BEGIN_DECLS

/* The paint. The colors are those of `surface`, or where that is NULL those of
 * `colors`, to 1/256 step. */
struct pel_phong {
    struct pel_color_paint base;
    const struct pel_mesh_lights *lights;
    const struct pel_color_paint *surface;
    struct pel_gouraud colors;
    struct pel_plane plane[6]; /* of the normal and of the position */
    uint8_t alpha;             /* multiplies that of the surface */
    uint8_t span; /* bits of it, for pel_phong_spans: 1..PEL_PHONG_SPAN_MOST */
};

enum { PEL_PHONG_SPAN_MOST = 3 };

/* Functions of that paint: light at every pixel, or at those whose x is a
 * multiple of a span, up to one on either side of the run. */
pel_colors_function pel_phong_colors, pel_phong_spans;

/* What changes along a row: the normal and the position where light is computed
 * next, and the color of a surface without a paint at the next pixel. */
struct pel_phong_row {
    uint64_t at[6];
    uint32_t own[3];
};

/* Gets the colors of the surface, which the light is then multiplied by. */
static inline void pel_phong_surface(const struct pel_phong *paint, int32_t x,
                                     int32_t y, int32_t n, pel_color *out)
{
    if (paint->surface)
        paint->surface->colors(paint->surface, x, y, n, out);
    else
        for (int32_t i = 0; i < n; i++)
            out[i] = UINT32_C(0xFF000000);
}

/* Sets it for a run from pixel x on, whose light is computed from `begin` on.
 */
static inline void pel_phong_start(struct pel_phong_row *row,
                                   const struct pel_phong *paint, int32_t x,
                                   int32_t begin, int32_t y)
{
    const struct pel_gouraud *own = &paint->colors;
    for (int k = 0; k < 6; k++)
        row->at[k] = pel_plane_at(&paint->plane[k], begin, y);
    for (int k = 0; k < 3 && !paint->surface; k++)
        row->own[k] = own->at[k] + PEL_CAST(uint32_t, x) * own->dx[k] +
                      PEL_CAST(uint32_t, y) * own->dy[k];
}

/* The light where the row is, which then goes on by 2^bits pixels. */
static inline void pel_phong_light(struct pel_phong_row *row,
                                   const struct pel_phong *paint, int bits,
                                   struct pel_light_sum *sum)
{
    int32_t value[6];
    PEL_UNROLL
    for (int k = 0; k < 6; k++) {
        value[k] = pel_plane_whole(row->at[k]);
        row->at[k] += bits ? paint->plane[k].dx << bits : paint->plane[k].dx;
    }
    pel_mesh_lights_sum(paint->lights, value + 3, value, sum);
}

/* A channel of struct pel_gouraud in 1/256 steps: it has a half more, so that
 * its upper 8 bits are rounded. */
static inline uint32_t pel_gouraud_channel(uint32_t v)
{
    return v < 0x800000u ? 0 : (v - 0x7F8000u) >> 16;
}

/* The color `under` a pixel, or the row's own, in the light; the row's goes on
 * by a pixel. */
static inline pel_color pel_phong_color(struct pel_phong_row *row,
                                        const struct pel_phong *paint,
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
