/* Lines one pixel wide. */
#ifndef PEL_RASTER_LINE_H
#define PEL_RASTER_LINE_H

#include "paint.h"

PEL_BEGIN_DECLS

/* Bresenham's line between the pixels that hold the two points, both ends
 * included: one pixel for every step along the longer side, the other
 * coordinate rounded to the nearest (a tie goes down or right). The same pixels
 * when the ends are swapped, and inside any clip; each pixel once. */
void pel_line(const struct pel_surface *surface, struct pel_point from,
              struct pel_point to, const struct pel_paint *paint);
PEL_END_DECLS
#endif
