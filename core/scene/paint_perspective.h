/* Textures in perspective: one division serves a number of pixels. */
#ifndef PEL_SCENE_PAINT_PERSPECTIVE_H
#define PEL_SCENE_PAINT_PERSPECTIVE_H

#include "../paint/paint_texture.h"
#include "../raster/plane.h"

PEL_BEGIN_DECLS

/* Pixels between divisions, a power of two: u and v are linear in spans of so
 * many pixels, each of which begins at a multiple of it. */
enum {
    PEL_SPAN_EXACT = 1, /* a division at every pixel */
    PEL_SPAN_MAX = 64
};

/* Planes over the screen: w, which is proportional to 1 / z and at most 2^30
 * inside the triangle, and (u - origin) w and (v - origin) w in 2^extent
 * texels 2^-16, so that their size is at most that of w. */
struct pel_perspective {
    struct pel_color_paint base;
    struct pel_texture *texture; /* the sampler; its map is overwritten */
    struct pel_plane w, uv[2];
    int64_t origin[2]; /* 1/65,536 texel */
    uint8_t extent[2];
    uint8_t span; /* bits of it: 0..6 */
};

/* A corner of a triangle in the texture. */
struct pel_texture_corner {
    int64_t uv[2]; /* 1/65,536 texel, below 2^37 in size */
    int32_t z;     /* the distance, in any unit; above 0 */
};

/* span: above, or 0, which is 1. Every pixel is divided in thin triangles, and
 * in spans whose ends lie too far outside of the triangle. A coordinate is
 * right to 1/256 texel in exact mode while the distances of the corners are
 * within a ratio of 256 and the triangle takes less than 4,096 texels. Between
 * divided positions it is off by at most du (r - 1) / 4, du the texels of a
 * span, r the ratio of the distances at its ends. The order of the corners does
 * not matter. */
void pel_perspective_init(struct pel_perspective *paint,
                          struct pel_texture *texture,
                          const struct pel_plane_setup *setup,
                          const struct pel_texture_corner corner[3],
                          int32_t span);
PEL_END_DECLS
#endif
