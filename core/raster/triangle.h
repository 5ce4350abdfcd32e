/* Filled triangles. */
#ifndef PEL_RASTER_TRIANGLE_H
#define PEL_RASTER_TRIANGLE_H

#include "paint.h"

PEL_BEGIN_DECLS

/* Fills the pixels whose centre lies inside the triangle (rule: raster/edge.h;
 * top-left, seen in a y-down surface). Exact for every legal vertex, in any
 * order of the vertices; a triangle without area covers nothing. */
void pel_triangle(const struct pel_surface *surface,
                  const struct pel_point v[3], const struct pel_paint *paint);

/* The same, but a triangle without area is drawn as the line between its two
 * extreme vertices (pel_line between the pixels that hold them). */
void pel_triangle_or_line(const struct pel_surface *surface,
                          const struct pel_point v[3],
                          const struct pel_paint *paint);

/* Twice the signed area in 1/65,536 px^2; positive when the vertices run
 * clockwise on screen. Below 2^50 in size; a vertex out of range is a broken
 * contract: PEL_ASSERT, and 0. */
int64_t pel_triangle_area(const struct pel_point v[3]);

/* The box of three points, and the pixels whose centres are inside a box of
 * sub-pixels; both half-open. */
static inline struct pel_rect pel_triangle_box(const struct pel_point v[3])
{
    struct pel_rect r;
    r.x0 = pel_min(pel_min(v[0].x, v[1].x), v[2].x);
    r.y0 = pel_min(pel_min(v[0].y, v[1].y), v[2].y);
    r.x1 = pel_max(pel_max(v[0].x, v[1].x), v[2].x);
    r.y1 = pel_max(pel_max(v[0].y, v[1].y), v[2].y);
    return r;
}

static inline struct pel_rect pel_box_pixels(const struct pel_rect *box)
{
    struct pel_rect r;
    r.x0 = pel_first_pixel(box->x0);
    r.y0 = pel_first_pixel(box->y0);
    r.x1 = pel_first_pixel(box->x1);
    r.y1 = pel_first_pixel(box->y1);
    return r;
}
PEL_END_DECLS
#endif
