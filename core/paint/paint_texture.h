/* Textures: pictures as paints, under any affine map. */
#ifndef PEL_PAINT_PAINT_TEXTURE_H
#define PEL_PAINT_PAINT_TEXTURE_H

#include "../raster/plane.h"
#include "paint_colors.h"

PEL_BEGIN_DECLS

/* The picture: 1 to 32,767 texels a side, in memory of the caller's that must
 * live as long as the paint. Either a surface in any format (its whole bounds;
 * opaque, but for argb8888 and palettes whose colors have alpha) or an array of
 * colors with straight alpha, row by row without padding. The first row in
 * memory is v = 0. */
struct pel_texels {
    const struct pel_surface *surface; /* or NULL, and then: */
    const pel_color *colors;
    int32_t width, height; /* of colors */
    bool opaque; /* all colors have alpha 255; false is right for any */
};

/* The texel that replaces one outside the picture, of W in a row or column. */
enum pel_wrap {
    PEL_WRAP_CLAMP,  /* the nearest: 0 or W - 1 */
    PEL_WRAP_REPEAT, /* i - W floor(i / W): the picture again and again */
    PEL_WRAP_MIRROR  /* repeat with every other picture mirrored: -1 is 0 */
};

/* The coordinates of the picture as planes (raster/plane.h) in 2^-32 texels.
 * Their whole parts must fit 32 bits at painted pixels. Texel i covers [i, i +
 * 1). */
struct pel_texture_map {
    struct pel_plane u, v; /* to the right, and down */
};

/* The map that shows the picture, a texel per pixel, with its corner at pixel
 * (x, y). */
#define PEL_TEXTURE_AT(x, y)                                                  \
    {                                                                         \
        {0x80000000u - (PEL_CAST(uint64_t, x) << 32), UINT64_C(1) << 32, 0},  \
        {                                                                     \
            0x80000000u - (PEL_CAST(uint64_t, y) << 32), 0, UINT64_C(1) << 32 \
        }                                                                     \
    }

/* A point of the picture; any number is legal. */
struct pel_texel_point {
    int32_t u, v; /* 1/256 texel */
};

/* The map that takes v[i] to t[i], right to 2^-14 texel inside the triangle.
 * The order of distinct vertices does not matter. A triangle without area gets
 * the point of its top vertex everywhere. PEL_ERROR_NULL, PEL_ERROR_RANGE (a
 * vertex out of range). */
enum pel_status pel_texture_map_triangle(struct pel_texture_map *map,
                                         const struct pel_point v[3],
                                         const struct pel_texel_point t[3]);

/* One plane of it, from values in 1/256 texel. */
void pel_texture_plane(struct pel_plane *plane,
                       const struct pel_plane_setup *setup,
                       const int32_t value[3]);

struct pel_texture {
    struct pel_color_paint base;
    struct pel_texture_map map;
    const struct pel_surface *surface; /* or NULL */
    const uint8_t *memory;             /* of texel (0, 0) */
    int32_t stride, width, height;     /* bytes, texels, texels */
    uint8_t wrap_u, wrap_v;            /* enum pel_wrap */
    uint8_t kind;                      /* paint_texture_fetch.h */
    pel_colors_function *blended;      /* of pel_texture_cut_out */
};

/* A texture with PEL_WRAP_CLAMP; wrap_u and wrap_v may be set afterwards.
 * Cheap: one for every triangle of a mesh is fine.
 *
 * Nearest: texel floor(u), floor(v). Fast for colors, argb8888, xrgb8888 and
 * rgb565_le; between surfaces of one 565 format texels are copied as they are.
 *
 * Bilinear: the four texels around u - 1/2, v - 1/2, with weights rounded to
 * 1/256 and the sum rounded once: off from exact weights by at most (Du + Dv) /
 * 512 + 1/2 steps, D the largest contrasts of neighbours. Channels of straight
 * alpha are mixed one by one.
 *
 * PEL_ERROR_NULL, PEL_ERROR_SIZE, PEL_ERROR_FORMAT (of a surface that cannot be
 * read: a fill-only twin). */
enum pel_status pel_texture_init_nearest(struct pel_texture *paint,
                                         const struct pel_texels *texels,
                                         const struct pel_texture_map *map);
enum pel_status pel_texture_init_bilinear(struct pel_texture *paint,
                                          const struct pel_texels *texels,
                                          const struct pel_texture_map *map);

/* Of a texture made by one of the two: where its alpha is below 128 nothing is
 * drawn, elsewhere it is opaque. */
void pel_texture_cut_out(struct pel_texture *paint);
PEL_END_DECLS
#endif
