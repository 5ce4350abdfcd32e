/* Mappings: how a texture lies on a mesh. */
#ifndef PEL_SCENE_MAPPING_H
#define PEL_SCENE_MAPPING_H

#include "frame.h"

PEL_BEGIN_DECLS

struct pel_mapping {
    /* The surface colour of a vertex, opaque. NULL: white. */
    pel_color (*vertex)(const struct pel_frame *frame, uint32_t vertex);

    /* The surface of frame->work->triangle, pixel by pixel, and a paint that
     * multiplies it by the corners' colours. NULL: none. */
    const struct pel_color_paint *(*surface)(struct pel_frame *frame);
    const struct pel_paint *(*tint)(struct pel_frame *frame,
                                    const struct pel_color_paint *surface,
                                    const pel_color color[3]);
};

/* A texel for every vertex. */
extern const struct pel_mapping pel_map_vertices;

/* u and v are linear on screen: right where a triangle's depth varies little;
 * off by at most du (r - 1) / 4, du its texels, r the ratio of its depths. */
extern const struct pel_mapping pel_map_affine;

/* In perspective, divided every `span` pixels (paint_perspective.h). */
extern const struct pel_mapping pel_map_perspective;

/* u and v of the mesh are 0 to 1 over the picture, v = 0 its first row, and
 * what lies outside is up to `wrap`. PEL_ERROR_RANGE of pel_scene_prepare: the
 * numbers of uv can say more than 2^21 texels; all within +-262,144 texels is
 * legal in what `pel import` writes. */
struct pel_mesh_texture {
    struct pel_texels texels;
    const struct pel_mapping *mapping;

    /* pel_texture_init_nearest or pel_texture_init_bilinear. */
    enum pel_status (*sampler)(struct pel_texture *paint,
                               const struct pel_texels *texels,
                               const struct pel_texture_map *map);
    enum pel_wrap wrap_u, wrap_v;
    int32_t span; /* of pel_map_perspective; 0 is 1, exact */
};

/* u (k = 0) or v (1) of a vertex, 1/65,536 texel. */
int64_t pel_texture_coordinate(const struct pel_frame *frame, uint32_t vertex,
                               int k);

/* The same of the corners of frame->work->triangle; z is left alone. */
void pel_mapping_corners(const struct pel_frame *frame,
                         struct pel_texture_corner corner[3]);

const struct pel_paint *pel_modulate(struct pel_frame *frame,
                                     const struct pel_color_paint *surface,
                                     const pel_color color[3]);
PEL_END_DECLS
#endif
