/* Smooth rectangles with round corners. */
#ifndef PEL_SMOOTH_SMOOTH_ROUNDED_RECTANGLE_H
#define PEL_SMOOTH_SMOOTH_ROUNDED_RECTANGLE_H

#include "../round/rounded_rectangle.h"
#include "smooth.h"

PEL_BEGIN_DECLS

/* Paints the rectangle from `from` to `to` with a quarter of a disc in each
 * corner, each pixel by its area (smooth.h), as pel_smooth_circle does, and as
 * exactly. Its radius is the given one, or half of the shorter side (rounded
 * down to a sub-pixel) if that is less; 0 gives the rectangle, within 1 of
 * pel_smooth_rectangle, the radius of a square's half the disc in it. Nothing
 * when to.x <= from.x or to.y
 * <= from.y. */
void pel_smooth_rounded_rectangle(const struct pel_surface *surface,
                                  const struct pel_rounded_shape *rectangle,
                                  const struct pel_paint *paint);
PEL_END_DECLS
#endif
