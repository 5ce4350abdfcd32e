/* Values in perspective: linear over a triangle in the world, so that they are
 * the quotients of two planes over the screen. One division serves all values
 * at a pixel, and they are linear in spans between two such pixels. */
#ifndef PEL_SCENE_DIVIDED_H
#define PEL_SCENE_DIVIDED_H

#include <stddef.h>

#include "../paint/paint_texture.h"

PEL_BEGIN_DECLS

/* Pixels between divisions, a power of two; a span begins at a multiple of
 * it. */
enum {
    PEL_SPAN_EXACT = 1, /* a division at every pixel */
    PEL_SPAN_MAX = 64
};

/* The plane of (value - origin) w in 2^extent units 2^-8, so that its size is
 * at most that of w. */
struct pel_divided_value {
    struct pel_plane plane;
    int64_t origin;
    uint8_t extent;
};

/* A paint that divides the values of a triangle, and has another one draw what
 * it has found: it sets at and dx of the planes there, 2^-24 units, to those of
 * a row from a pixel on, which is pixel (0, 0) of them. w is proportional to
 * 1 / z and at most 2^30 inside the triangle. At a divided pixel a value is
 * right to 2^-28 of 2^extent while the distances of the corners are within a
 * ratio of 256. Between two it is off by at most du (r - 1) / 4, du the change
 * over the span, r the ratio of the distances at its ends. */
struct pel_divided {
    struct pel_color_paint base;
    const struct pel_color_paint *inner;
    /* Are its planes good enough over the span from pixel (x, y) on? Elsewhere
     * every pixel of it is divided. NULL: they are. */
    bool (*is_near)(const struct pel_divided *divided, int32_t x, int32_t y);
    struct pel_plane w;
    int32_t corner[3]; /* w there */
    uint8_t values;    /* so many follow this struct in memory */
    uint8_t span;      /* bits of it: 0..6 */
    uint16_t planes;   /* the offset of the first in the inner paint, bytes */
};

/* The planes of its inner paint. */
struct pel_plane *pel_divided_planes(const struct pel_divided *divided);

/* All but the values and `planes`; opaque where the inner paint is. z[i]: the
 * distance of corner i, in any unit, above 0. span: above, or 0, which is 1; in
 * triangles thinner than a pixel it is 1 always. The order of the corners does
 * not matter. */
void pel_divided_init(struct pel_divided *divided,
                      const struct pel_color_paint *inner,
                      const struct pel_plane_setup *setup, const int32_t z[3],
                      int32_t span);

/* corner[i]: the value at corner i, 2^-8 units, below 2^45 in size; differences
 * are below 2^39. */
void pel_divided_set(struct pel_divided_value *value,
                     const struct pel_divided *divided,
                     const struct pel_plane_setup *setup,
                     const int64_t corner[3]);

pel_colors_function pel_divided_colors;

/* A texture: its map is overwritten. */
struct pel_divided_texture {
    struct pel_divided by;
    struct pel_divided_value uv[2];
};

/* A corner of a triangle in it. */
struct pel_texture_corner {
    int64_t uv[2]; /* 1/65,536 texel, below 2^37 in size */
    int32_t z;     /* the distance, in any unit; above 0 */
};

/* A coordinate is right to 1/256 texel in exact mode while the distances of the
 * corners are within a ratio of 256 and the triangle takes less than 4,096
 * texels. */
void pel_divided_texture_init(struct pel_divided_texture *paint,
                              struct pel_texture *texture,
                              const struct pel_plane_setup *setup,
                              const struct pel_texture_corner corner[3],
                              int32_t span);
PEL_END_DECLS
#endif
