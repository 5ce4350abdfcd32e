/* The rows of a rounded rectangle: a disc pulled apart (disc.h) to the centres
 * of the four corners. */
#ifndef PEL_ROUND_ROUNDED_RECTANGLE_WALK_H
#define PEL_ROUND_ROUNDED_RECTANGLE_WALK_H

#include "disc.h"
#include "rounded_rectangle.h"

struct pel_rounded_walk {
    struct pel_disc disc; /* at row y */
    int64_t half_width2;
    int32_t top, bottom; /* of the centres, 1/256 px */
    int32_t radius;
    struct pel_rect visible; /* the rows that are left */
};

/* false: nothing is covered, or the rectangle is out of range (PEL_ASSERT). */
bool pel_rounded_start(struct pel_rounded_walk *w,
                       const struct pel_rounded_shape *r,
                       const struct pel_rect *clip);

/* False when the next row has the same span. */
bool pel_rounded_next(struct pel_rounded_walk *w);

#endif
