/* The painter: a projected mesh, drawn back to front. */
#ifndef SIM_RENDER_PAINTER_H
#define SIM_RENDER_PAINTER_H

#include "core/base/surface.h"
#include "sim/mesh/pel2d.h"

enum painter_shade {
    PAINTER_FLAT,   /* the mean of the three colours, rounded */
    PAINTER_GOURAUD /* pel_triangle_gouraud */
};

struct painter {
    const struct pel2d *flat; /* the caller's */
    uint32_t *order;          /* triangles, the farthest first; malloc'ed */
    enum painter_shade shade;
    bool lines; /* a triangle without area is a line, in its mean colour */
};

/* Sorts the triangles by their mean depth, compared as the exact sum of three;
 * equal ones stay in the order of their indices. Shade and lines are for the
 * caller to set. False, with a message on standard error, when memory is short.
 */
bool painter_init(struct painter *painter, const struct pel2d *flat);
void painter_free(struct painter *painter);

/* Draws all triangles; `context` is the struct painter (canvas_draw). */
void painter_draw(struct pel_surface *surface, void *context);

#endif
