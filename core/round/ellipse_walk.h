/* The walk over the rows of an ellipse: as that of a disc (disc.h).
 *
 * With a, b the radii, row v holds the columns with
 * u^2 <= a^2 (b^2 - v^2) / b^2, and since u^2 is a whole number, with
 * u^2 <= half_width2, the floor of that.
 *
 * The numerator is a polynomial of degree 2 in the row, so the floor follows
 * exactly from two additions a row. All three terms are kept as quotient and
 * remainder by b^2: the value itself, its first difference
 * - a^2 (512 v + 65,536), and its second difference - 131,072 a^2.
 *
 * Ranges: a^2, b^2 <= 2^46. There are two rows only when b >= 128, and
 * |v| <= b: so the differences are at most a^2 (512 / b + 65,536 / b^2) <= 2^49
 * and 131,072 a^2 / b^2 <= 2^49. A radius below half a pixel has one row at
 * most and needs no differences. */
#ifndef PEL_ROUND_ELLIPSE_WALK_H
#define PEL_ROUND_ELLIPSE_WALK_H

#include "disc.h"
#include "ellipse.h"

struct pel_quotient {
    int64_t q, r; /* stands for q + r / b^2, 0 <= r < b^2 */
};

struct pel_ellipse_walk {
    struct pel_disc disc; /* at row y */
    struct pel_quotient half_width2, delta, delta2;
    int32_t y, end;
};

/* false: nothing is covered, or the ellipse is out of range (PEL_ASSERT). */
bool pel_ellipse_start(struct pel_ellipse_walk *w,
                       const struct pel_ellipse_shape *e,
                       const struct pel_rect *clip);

void pel_ellipse_next(struct pel_ellipse_walk *w,
                      const struct pel_ellipse_shape *e);

#endif
