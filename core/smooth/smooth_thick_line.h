/* Smooth straight lines of any width. */
#ifndef PEL_SMOOTH_SMOOTH_THICK_LINE_H
#define PEL_SMOOTH_SMOOTH_THICK_LINE_H

#include "../raster/thick_line.h"
#include "smooth_convex.h"

PEL_BEGIN_DECLS

/* Paints the polygon of pel_thick_line_corners: ends that are cut straight,
 * across the line. A line out of range, or a corner of it, is a broken
 * contract.
 *
 * Along the silhouette of a mesh, whose inside is not smooth, a line of 1 to
 * 1.5 px in the color of the mesh makes the edge soft. */
void pel_smooth_thick_line(const struct pel_surface *surface,
                           const struct pel_thick_line_shape *line,
                           const struct pel_paint *paint);

/* The same with square ends: half of the width longer at both. A line without
 * length is nothing. */
void pel_smooth_thick_line_square(const struct pel_surface *surface,
                                  const struct pel_thick_line_shape *line,
                                  const struct pel_paint *paint);

/* The same with round ends: all points within half of the width, rounded down
 * to 1/256 px, of the line between the two ends, within 1.1 of 255 times their
 * area in a pixel up to widths of 4,096 px. Without length it is a disc. The
 * two ends and the width must be in range, not the corners. */
void pel_smooth_thick_line_round(const struct pel_surface *surface,
                                 const struct pel_thick_line_shape *line,
                                 const struct pel_paint *paint);
PEL_END_DECLS
#endif
