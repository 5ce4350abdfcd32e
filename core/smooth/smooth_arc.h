/* Smooth arcs and sectors. */
#ifndef PEL_SMOOTH_SMOOTH_ARC_H
#define PEL_SMOOTH_SMOOTH_ARC_H

#include "../round/arc.h"
#include "../round/sector.h"
#include "smooth.h"

PEL_BEGIN_DECLS

/* Paints the part of pel_smooth_ring between two angles, clockwise from the ray
 * of `from` to that of `to`, each pixel by its area (smooth.h): within 1.2 of
 * 255 times that up to a radius of 2,048 px. Rays have the integer directions
 * of pel_direction. Nothing when outer <= inner or from and to are one angle;
 * the whole ring when to - from is 65,536 or more. */
void pel_smooth_arc(const struct pel_surface *surface,
                    const struct pel_arc_shape *arc,
                    const struct pel_paint *paint);

/* The same with round ends, as of a gauge: half discs beyond the two rays,
 * half as large as the arc is wide. Their centres lie on the middle circle,
 * whose radius is (inner + outer) / 2, and all three are in 1/256 px: both
 * radii rounded down, the centres within .51 of where they are. Within 1.2 of
 * 255 times the area of these, and within 2.4 where both ends share a pixel.
 * Where the ends meet, as of a gauge near 100 %, their coverage adds up, to 255
 * at most. */
void pel_smooth_arc_round(const struct pel_surface *surface,
                          const struct pel_arc_shape *arc,
                          const struct pel_paint *paint);

/* Paints a sector of a disc: the arc of inner radius 0. */
void pel_smooth_sector(const struct pel_surface *surface,
                       const struct pel_sector_shape *sector,
                       const struct pel_paint *paint);
PEL_END_DECLS
#endif
