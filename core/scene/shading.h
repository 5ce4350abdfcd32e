/* Shadings: where on a triangle colors are computed. Textures are in mapping.h,
 * and what both are made of in work.h. */
#ifndef PEL_SCENE_SHADING_H
#define PEL_SCENE_SHADING_H

#include "../base/surface.h"
#include "light.h"
#include "scene.h"

PEL_BEGIN_DECLS

struct pel_color_paint;
struct pel_frame_vertex;
struct pel_frame_work;
struct pel_paint;

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
    struct pel_projector projector;
};

/* Makes the paint of frame->work->triangle, whose vertices have these colors.
 * `surface` is a texture that is mapped to every pixel, or NULL; where it is
 * not opaque, the paint is a struct pel_color_paint too. */
typedef const struct pel_paint *pel_shade_function(
    struct pel_frame *frame, const struct pel_color_paint *surface,
    const pel_color color[3]);

/* The paint of that triangle in one color, or linear between its vertices';
 * where there is a surface, that multiplied by it. */
const struct pel_paint *pel_frame_flat_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface,
    pel_color color);
pel_shade_function pel_frame_gouraud_paint;

/* The color of a vertex before it is lit: that of the texture, the mesh or the
 * part at hand, with the part's alpha. */
pel_color pel_frame_surface(const struct pel_frame *frame, uint32_t vertex);

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
 * screen, and the normal is scaled to length 1 without a division. Where
 * opposite normals cancel out there is ambient light alone. */
extern const struct pel_shading pel_shade_phong;

/* Its paint, of surface colors. */
pel_shade_function pel_phong_paint;

PEL_END_DECLS
#endif
