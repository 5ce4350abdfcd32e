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
PEL_END_DECLS
#endif
