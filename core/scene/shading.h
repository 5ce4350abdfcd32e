/* Shadings: where on a triangle colors are computed. Mappings: how a texture
 * lies on a mesh. */
#ifndef PEL_SCENE_SHADING_H
#define PEL_SCENE_SHADING_H

#include "frame.h"

PEL_BEGIN_DECLS

struct pel_shading {
    /* Called once a frame, before the vertices. May be NULL. */
    enum pel_status (*start)(struct pel_frame *frame);

    /* The color that a vertex keeps, from its own. NULL: its own. */
    pel_color (*vertex)(const struct pel_frame *frame, uint32_t vertex,
                        pel_color surface);

    /* The paint of frame->work->triangle. `surface` is a texture that is mapped
     * to every pixel, or NULL; where it is not opaque, the paint is a struct
     * pel_color_paint too. */
    const struct pel_paint *(*paint)(struct pel_frame *frame,
                                     const struct pel_color_paint *surface);
};

/* Without light: the colors of the vertices, or of a texture, as they are.
 * Flat: the mean of the three, rounded. Gouraud: linear on screen. */
extern const struct pel_shading pel_shade_flat;
extern const struct pel_shading pel_shade_gouraud;

/* The same with light at the vertices (light.h). A texture that is mapped to
 * every pixel is multiplied by the light on white, highlights too. */
extern const struct pel_shading pel_shade_lit_flat;
extern const struct pel_shading pel_shade_lit_gouraud;

/* Light at every pixel: normal, position and surface color are linear on
 * screen, the normal scaled to length 1 without a division. Where opposite
 * normals cancel out there is ambient light alone. */
extern const struct pel_shading pel_shade_phong;

struct pel_mapping {
    /* The surface color of a vertex, opaque. NULL: white. */
    pel_color (*vertex)(const struct pel_frame *frame, uint32_t vertex);

    /* The surface of frame->work->triangle, pixel by pixel, and a paint that
     * multiplies it by the corners' colors. NULL: none. */
    const struct pel_color_paint *(*surface)(struct pel_frame *frame);
    const struct pel_paint *(*modulate)(struct pel_frame *frame,
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

/* u and v of the mesh are 0 to 1 over the picture, v = 0 its first row; `wrap`
 * applies outside. pel_scene_prepare gives PEL_ERROR_RANGE when uv can exceed
 * 2^21 texels; all within +-262,144 texels is legal in what `pel import`
 * writes. */
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
PEL_END_DECLS
#endif
