/* Shadings: where on a triangle colors are computed. Mappings: how a texture
 * lies on a mesh. */
#ifndef PEL_SCENE_SHADING_H
#define PEL_SCENE_SHADING_H

#include "../raster/gouraud.h"
#include "clip.h"
#include "depth.h"
#include "light.h"
#include "paint_perspective.h"
#include "scene.h"
#include "shaded.h"
#include "perspective.h"

PEL_BEGIN_DECLS

struct pel_frame_vertex {
    struct pel_projected at;
    pel_color color; /* of triangles that may be seen; 0: see pel_frame_color */
};

/* A triangle to draw: one of the mesh, or a part of it that clipping left. */
struct pel_frame_triangle {
    bool is_whole; /* its corners are the vertices */
    bool is_set_up;
    uint32_t vertex[3];
    pel_color color[3]; /* of the vertices, when it is drawn */
    struct pel_point at[3];
    const struct pel_clip_corner *corner[3];
};

/* Scratch memory for one triangle at a time. */
struct pel_frame_work {
    struct pel_frame_triangle triangle;
    struct pel_surface surface;
    struct pel_plane_setup setup; /* of the triangle: see pel_frame_setup */
    union {
        struct pel_flat flat;
        struct pel_gouraud gouraud;
        struct pel_shaded shaded;
    } paint;
    struct pel_perspective perspective;
    struct pel_depth_paint depth;
    struct pel_clip clip;
    uint8_t method; /* of the triangle, where one is chosen (select.h) */
    uint32_t bound; /* then of its error, 1/256 step */
};

/* What is drawn: all, or what can store depths, or the rest of it. */
enum pel_pass { PEL_PASS_ALL, PEL_PASS_FIRST, PEL_PASS_TRANSLUCENT };

/* Small members come first: a Cortex-M0+ reaches bytes in 32 bytes and words in
 * 128. */
struct pel_frame {
    const struct pel_scene *scene;
    struct pel_frame_work *work;
    struct pel_frame_vertex *vertex;
    struct pel_depth_entry *order; /* NULL: that of the mesh */
    bool translucent;              /* some part is not solid */
    enum pel_pass pass;

    /* The part of the mesh at hand, or all of it. */
    uint8_t alpha;
    bool opaque;               /* no pixel is translucent, nor left out */
    bool solid;                /* no pixel is translucent */
    uint32_t part, begin, end; /* triangles */
    pel_color color;           /* of vertices without colors */
    const struct pel_mesh_texture *mesh_texture; /* NULL: no texture */

    uint32_t triangles; /* in `order`: those that may be seen */
    /* Puts a paint between a triangle and its paint. NULL: none. */
    const struct pel_paint *(*filter)(struct pel_frame *frame,
                                      const struct pel_paint *paint);
    int32_t tolerance; /* the scene's less what lights that are left out take */
    struct pel_mesh_fault fault;   /* when an index or a part is wrong */
    struct pel_mesh_lights lights; /* lighting is NULL without light */
    struct pel_texture texture;    /* of mesh_texture; mappings set its map */
    struct pel_projector projector;
};

/* Sets the part at hand: number i, 0 for a mesh without parts. Errors of
 * pel_scene_prepare about textures. */
enum pel_status pel_frame_set_part(struct pel_frame *frame, uint32_t i);

/* Sets it to that of a triangle of the mesh. */
void pel_frame_find_part(struct pel_frame *frame, uint32_t triangle);

/* The values at the corners from those at the vertices, |value| <= 2^30. */
void pel_corners_mix(const struct pel_frame_triangle *triangle,
                     const int32_t vertex[3], int32_t corner[3]);

/* The plane set-up of frame->work->triangle, computed by the first call. */
const struct pel_plane_setup *pel_frame_setup(struct pel_frame *frame);

/* The plane of a value over that triangle, from its three vertices. */
void pel_frame_plane(struct pel_frame *frame, const int32_t value[3],
                     struct pel_plane *plane);

/* The normal and the position of a vertex. */
void pel_frame_values(const struct pel_frame *frame, uint32_t vertex,
                      int32_t value[PEL_LIGHT_VALUES]);

/* Sets the paint to colors that are linear over that triangle, from those of
 * its vertices, right to 2^-6 step. */
void pel_frame_gouraud(struct pel_frame *frame, const pel_color color[3],
                       struct pel_gouraud *paint);

/* The paint of that triangle in one color, or linear between its vertices';
 * where there is a surface, that multiplied by it. */
const struct pel_paint *pel_frame_flat_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface,
    pel_color color);
pel_shade_function pel_frame_gouraud_paint;

/* The color of a vertex before it is lit: that of the texture, the mesh or the
 * part at hand, with the part's alpha. */
pel_color pel_frame_surface(const struct pel_frame *frame, uint32_t vertex);

/* The color of a vertex, lit by shadings that light vertices; computed by the
 * first call. */
pel_color pel_frame_color(const struct pel_frame *frame, uint32_t vertex);

/* True when the box around three corners holds the centre of a pixel of the
 * rectangle: no other triangle covers any. */
bool pel_box_meets(const struct pel_point at[3], const struct pel_rect *rect);

/* Where a corner that clipping left of that triangle is on screen. A vertex
 * that is on screen keeps its sub-pixel, so that triangles around it meet
 * there. */
struct pel_point pel_frame_corner_at(const struct pel_frame *frame,
                                     const struct pel_clip_corner *corner);

struct pel_shading {
    /* Called once a frame, before the vertices. May be NULL. */
    enum pel_status (*start)(struct pel_frame *frame);

    /* Makes the color that a vertex keeps from its own (pel_frame_surface).
     * NULL: keeps its own. */
    pel_color (*vertex)(const struct pel_frame *frame, uint32_t vertex,
                        pel_color surface);

    pel_shade_function *paint; /* of the colors that the vertices keep */

    /* Bytes of scratch memory that it takes besides, a multiple of 8: they
     * follow frame->work[0]. */
    size_t memory;
};

/* Without light: the colors of the vertices, or of a texture, as they are.
 * Flat: the mean of the three, rounded. Gouraud: linear on screen. */
extern const struct pel_shading pel_shade_flat;
extern const struct pel_shading pel_shade_gouraud;

/* The same with light (light.h): Gouraud's at the vertices; flat, at the middle
 * of the triangle with its own normal, so that the mesh needs none. A texture
 * that is mapped to every pixel is multiplied by the light on white, highlights
 * too. */
extern const struct pel_shading pel_shade_lit_flat;
extern const struct pel_shading pel_shade_lit_gouraud;

/* Their `start` and `vertex`; and `start` of all that need normals. */
enum pel_status pel_frame_start_light(struct pel_frame *frame);
pel_color pel_frame_light_vertex(const struct pel_frame *frame, uint32_t vertex,
                                 pel_color surface);

/* Light at every pixel: normal, position and surface color are linear on
 * screen, the normal scaled to length 1
 * without a division. Where opposite normals cancel out there is ambient light
 * alone. */
extern const struct pel_shading pel_shade_phong;

/* Its paint, of surface colors. */
pel_shade_function pel_phong_paint;

/* Its steps: the paint without its planes; `set` for each of its values, from
 * those at the triangle's vertices. */
typedef void pel_value_function(struct pel_frame *frame, int k,
                                const int32_t vertex[3]);
struct pel_shaded *pel_phong_start(struct pel_frame *frame,
                                   const struct pel_color_paint *surface);
void pel_phong_values(struct pel_frame *frame, const pel_color color[3],
                      pel_value_function *set);

/* pel_texture_init_nearest or pel_texture_init_bilinear. */
typedef enum pel_status pel_sampler(struct pel_texture *paint,
                                    const struct pel_texels *texels,
                                    const struct pel_texture_map *map);

struct pel_mapping {
    /* The surface color of a vertex, opaque. NULL: white. */
    pel_color (*vertex)(const struct pel_frame *frame, uint32_t vertex);

    /* The surface of frame->work->triangle, pixel by pixel, and a paint that
     * multiplies it by the corners' colors. NULL: none. */
    const struct pel_color_paint *(*surface)(struct pel_frame *frame);
    pel_shade_function *modulate;
};

/* What mappings are made of. Sets the corners of frame->work->triangle; the
 * affine surface of it; `modulate`. */
void pel_frame_texels(const struct pel_frame *frame,
                      struct pel_texture_corner corner[3]);
const struct pel_color_paint *pel_frame_affine(struct pel_frame *frame);
pel_shade_function pel_frame_modulate;

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

    pel_sampler *sampler;
    void (*alpha)(struct pel_texture *paint); /* NULL: blended; or
                                                 pel_texture_cut_out */
    enum pel_wrap wrap_u, wrap_v;
    int32_t span; /* of pel_map_perspective; 0 is 1, exact */
};

/* Sets texels, wrap and alpha to those of an asset's texture, whose
 * pixels are of that format; mapping, sampler and span stay. The surface is the
 * caller's, and lives as long as the texture. PEL_ERROR_NULL, errors of
 * pel_image_asset_surface. */
enum pel_status pel_mesh_texture_of_image(struct pel_mesh_texture *texture,
                                          struct pel_surface *surface,
                                          const struct pel_mesh_image *image,
                                          const struct pel_format *format);
PEL_END_DECLS
#endif
