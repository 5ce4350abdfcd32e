/* Smooth rectangles: sides between pixels. */
#ifndef PEL_SMOOTH_SMOOTH_RECTANGLE_H
#define PEL_SMOOTH_SMOOTH_RECTANGLE_H

#include "smooth.h"

PEL_BEGIN_DECLS

/* Paints [from.x, to.x) x [from.y, to.y), in sub-pixels: coverage is 255 times
 * the area in the pixel, rounded (a half up). Nothing when to.x <= from.x or
 * to.y <= from.y. A rectangle of whole pixels is pel_rectangle's. */
void pel_smooth_rectangle(const struct pel_surface *surface,
                          struct pel_point from, struct pel_point to,
                          const struct pel_paint *paint);
PEL_END_DECLS
#endif
