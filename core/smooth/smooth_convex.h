/* Smooth polygons that need no memory: triangles, and any convex outline. */
#ifndef PEL_SMOOTH_SMOOTH_CONVEX_H
#define PEL_SMOOTH_SMOOTH_CONVEX_H

#include "smooth.h"

PEL_BEGIN_DECLS

/* Paints the triangle, every pixel by the part of it that lies inside: what
 * pel_triangle covers as a whole, and the edges softly. With k edges in a pixel
 * coverage is within .5 + .02 k of 255 times the exact area
 * (smooth_edge.h), for every legal vertex, slivers included; the order of the
 * vertices, whole-pixel shifts, bands and clips change no byte. A vertex out of
 * range is a broken contract: PEL_ASSERT, and nothing is drawn. */
void pel_smooth_triangle(const struct pel_surface *surface,
                         const struct pel_point v[3],
                         const struct pel_paint *paint);

/* The same of a convex polygon of n vertices in either direction; fewer than 3
 * cover nothing. Of an outline that is not convex it covers something, in
 * pixels that its box touches, which may differ between builds:
 * pel_smooth_polygon takes all. */
void pel_smooth_convex(const struct pel_surface *surface,
                       const struct pel_point *v, int32_t n,
                       const struct pel_paint *paint);
PEL_END_DECLS
#endif
