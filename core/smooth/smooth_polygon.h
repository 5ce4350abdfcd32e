/* Smooth polygons with any number of vertices, which may cross themselves. */
#ifndef PEL_SMOOTH_SMOOTH_POLYGON_H
#define PEL_SMOOTH_SMOOTH_POLYGON_H

#include "../raster/polygon.h"
#include "smooth.h"

PEL_BEGIN_DECLS

/* Bytes of scratch memory, aligned to 8, that a polygon of n vertices needs on
 * a surface whose clip is `width` px wide, for constant expressions; and the
 * same as a function: 0 when n < 1, width < 0, or when the size does not fit.
 */
#define PEL_SMOOTH_POLYGON_SCRATCH_SIZE(n, width)                   \
    (PEL_CAST(size_t, n) * 52 + (PEL_CAST(size_t, width) + 1) * 4 + \
     52 * sizeof(void *))
size_t pel_smooth_polygon_scratch_size(int32_t n, int32_t width);

/* Paints every pixel by the part of it that is inside, by the rule of the
 * polygon. Exact where the outline crosses or overlaps itself, too: a row is
 * cut where an edge begins, ends or crosses another, and between two cuts the
 * rule says which edges are the border. With k pieces of the border in a pixel
 * (edges, and one more for each cut) coverage is within .5 + .02 k of 255 times
 * the exact area. Scratch memory is the caller's, may hold anything, and may be
 * used again after the call.
 *
 * Time is O(n^1.5), plus for every visible row a few steps for each edge in it.
 * A row is cut where edges meet, and only they are: m edges that share columns
 * take m steps for each of their cuts, up to m^2 / 2 where all of them cross
 * each other. Convex outlines are faster by pel_smooth_convex.
 * PEL_ERROR_NULL, PEL_ERROR_SCRATCH (too small, or not aligned to 8),
 * PEL_ERROR_RANGE (a vertex out of range): nothing is drawn then. */
enum pel_status pel_smooth_polygon(const struct pel_surface *surface,
                                   const struct pel_polygon_shape *polygon,
                                   const struct pel_paint *paint, void *scratch,
                                   size_t size);
PEL_END_DECLS
#endif
