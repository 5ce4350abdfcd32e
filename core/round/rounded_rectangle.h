/* Filled rectangles with round corners. */
#ifndef PEL_ROUND_ROUNDED_RECTANGLE_H
#define PEL_ROUND_ROUNDED_RECTANGLE_H

#include "../raster/paint.h"

PEL_BEGIN_DECLS

struct pel_rounded_shape {
    struct pel_point from, to; /* as in pel_rectangle */
    int32_t radius;            /* 1/256 px, 0..32,767 px */
};

/* Fills the pixels of pel_rectangle(from, to) whose centre is at most r away
 * from the rectangle that is smaller by r on every side, exactly; r is the
 * radius, or half of the shorter side (rounded down to a sub-pixel) if that is
 * less. So radius 0 gives pel_rectangle, and each corner is a quarter of the
 * closed disc of pel_circle. Nothing when to.x <= from.x or to.y <= from.y. */
void pel_rounded_rectangle(const struct pel_surface *surface,
                           const struct pel_rounded_shape *rectangle,
                           const struct pel_paint *paint);
PEL_END_DECLS
#endif
