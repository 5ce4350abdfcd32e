/* Textures in perspective: u and v are values of divided.h. */
#ifndef PEL_SCENE_PAINT_PERSPECTIVE_H
#define PEL_SCENE_PAINT_PERSPECTIVE_H

#include "../paint/paint_texture.h"
#include "divided.h"

PEL_BEGIN_DECLS

struct pel_perspective {
    struct pel_color_paint base;
    struct pel_texture *texture; /* the sampler; its map is overwritten */
    struct pel_divided divided;
    struct pel_divided_value uv[2];
};

/* A corner of a triangle in the texture. */
struct pel_texture_corner {
    int64_t uv[2]; /* 1/65,536 texel, below 2^37 in size */
    int32_t z;     /* the distance, in any unit; above 0 */
};

/* span: of pel_divided_init. A coordinate is right to 1/256 texel in exact mode
 * while the distances of the corners are within a ratio of 256 and the triangle
 * takes less than 4,096 texels. */
void pel_perspective_init(struct pel_perspective *paint,
                          struct pel_texture *texture,
                          const struct pel_plane_setup *setup,
                          const struct pel_texture_corner corner[3],
                          int32_t span);
PEL_END_DECLS
#endif
