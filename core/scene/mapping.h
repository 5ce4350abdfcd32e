/* Mappings: how a texture lies on a mesh. */
#ifndef PEL_SCENE_MAPPING_H
#define PEL_SCENE_MAPPING_H

#include "../paint/paint_texture.h"
#include "shading.h"

PEL_BEGIN_DECLS

struct pel_mesh_image;

/* pel_texture_init_nearest or pel_texture_init_bilinear. */
typedef enum pel_status pel_sampler(struct pel_texture *paint,
                                    const struct pel_texels *texels,
                                    const struct pel_texture_map *map);

struct pel_mapping {
    /* The surface color of a vertex, opaque. NULL: white. */
    pel_color (*vertex)(const struct pel_frame *frame, uint32_t vertex);

    /* The surface of frame->work->triangle, pixel by pixel, and a paint that
     * multiplies it by the colors of the vertices. NULL: none. */
    const struct pel_color_paint *(*surface)(struct pel_frame *frame);
    pel_shade_function *modulate;
};

/* A texel for every vertex. */
extern const struct pel_mapping pel_map_vertices;

/* u and v are linear on screen: right where a triangle's depth varies little;
 * off by at most du (r - 1) / 4, du its texels, r the ratio of its depths. */
extern const struct pel_mapping pel_map_affine;

/* In perspective, divided every `span` pixels (divided.h). */
extern const struct pel_mapping pel_map_perspective;

/* u and v of the mesh are 0 to 1 over the picture, v = 0 its first row; `wrap`
 * applies outside. pel_scene_prepare gives PEL_ERROR_RANGE when uv can exceed
 * 2^21 texels; all within +-262,144 texels is legal in what `pel import`
 * writes. */
struct pel_mesh_texture {
    struct pel_texels texels;
    const struct pel_mapping *mapping;

    pel_sampler *sampler;
    void (*alpha)(struct pel_texture *paint); /* NULL: blended; or
                                                 pel_texture_cut_out */
    enum pel_wrap wrap_u, wrap_v;
    int32_t span; /* of pel_map_perspective; 0 is 1, exact */
};

/* Sets texels, wrap and alpha to those of an asset's texture, whose pixels are
 * of that format; mapping, sampler and span stay. The surface is the caller's,
 * and lives as long as the texture. PEL_ERROR_NULL, errors of
 * pel_image_asset_surface. */
enum pel_status pel_mesh_texture_of_image(struct pel_mesh_texture *texture,
                                          struct pel_surface *surface,
                                          const struct pel_mesh_image *image,
                                          const struct pel_format *format);
PEL_END_DECLS
#endif
