/* A projected mesh, drawn back to front. */
#ifndef SIM_RENDER_PAINTER_H
#define SIM_RENDER_PAINTER_H

#include "core/paint/paint_texture.h"
#include "sim/mesh/pel2d.h"
#include "sim/image/picture.h"

enum painter_shade {
    PAINTER_FLAT,   /* the mean of the three colors, rounded */
    PAINTER_GOURAUD /* pel_triangle_gouraud */
};

/* A texture instead of the colors: texel floor(u (W - 1)), floor(v (H - 1)),
 * or the four around u (W - 1) - 1/2, v (H - 1) - 1/2. */
struct painter_texture {
    struct picture picture;
    bool opaque, bilinear;
    enum pel_wrap wrap; /* of texels outside */
};

struct painter_item {
    struct mesh_depth depth; /* the sum of three */
    uint32_t triangle;
};

struct painter {
    const struct pel2d *flat;              /* the caller's */
    const struct painter_texture *texture; /* the caller's, or NULL */
    struct painter_item *item;             /* the farthest first; malloc'ed */
    enum painter_shade shade;
    bool lines; /* a triangle without area is a line, in its mean color */
};

/* Sorts the triangles by their mean depth, compared as the exact sum of three;
 * equal ones stay in the order of their indices. The others are for
 * the caller to set before. False, with a message on standard error, when
 * memory is short or a vertex lies 2^23 texels or more outside of the texture.
 */
bool painter_init(struct painter *painter, const struct pel2d *flat);
void painter_free(struct painter *painter);

/* Draws all triangles; `context` is the struct painter (canvas_draw). */
void painter_draw(struct pel_surface *surface, void *context);

#endif
