/* The rows of an ellipse, as those of a disc (disc.h).
 *
 * With a, b the radii, the row at distance v holds the columns with
 * u^2 <= a^2 (b^2 - v^2) / b^2. Since u^2 is a whole number, half_width2 is the
 * floor of that.
 *
 * The numerator is a polynomial of degree 2 in the row, so the floor follows
 * exactly from two additions a row. Three terms are kept as quotient and
 * remainder by b^2: half_width2, its first difference delta,
 * -a^2 (512 v + 65,536) / b^2, and its second difference delta2,
 * -131,072 a^2 / b^2.
 *
 * Ranges: a^2, b^2 <= 2^46. There are two rows only when b >= 128, and
 * |v| <= b: so the differences are at most a^2 (512 / b + 65,536 / b^2) <= 2^49
 * and 131,072 a^2 / b^2 <= 2^49. With b < 128 there is one row at most, and no
 * difference is needed. */
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
