/* Pieces of a row and the cubic in one, for curve_colors.h. */
#ifndef PEL_PAINT_CURVE_PIECE_H
#define PEL_PAINT_CURVE_PIECE_H

#include "../pel_config.h"
#include "curve.h"

/* A run's curve and row. */
struct pel_curve_row {
    const struct pel_curve *curve;
    int32_t dy;     /* from the centre */
    int64_t square; /* dy^2 */
};

static inline struct pel_curve_row pel_curve_row_of(
    const struct pel_curve *curve, int32_t y)
{
    const int32_t dy = pel_pixel_center(y) - curve->center.y;
    return (struct pel_curve_row){curve, dy, pel_square(dy)};
}

/* Is every centre from dx to `way` sub-pixels right of it at least `limit` away
 * from the paint's? */
static inline bool pel_curve_far(const struct pel_curve_row *row, int32_t dx,
                                 int32_t way, int32_t limit)
{
    int32_t x = dx > 0 ? dx : pel_min(dx + way, 0);
    return pel_square(x) + row->square >= pel_square(limit);
}

static inline int32_t pel_curve_way(const struct pel_curve_row *row, int32_t x)
{
    return pel_pixel_center(x) - row->curve->center.x;
}

/* log2 of the size of the piece that holds pixel x; 0 when no piece is far
 * enough. */
static PEL_WALK int pel_curve_piece(const struct pel_curve_row *row, int32_t x)
{
    int32_t size = 1 << PEL_PIECE_MAX_LOG2;
    int k = PEL_PIECE_MAX_LOG2;
    for (; k >= PEL_PIECE_MIN_LOG2; k--, size >>= 1)
        if (pel_curve_far(row, pel_curve_way(row, x & -size), 256 * size,
                          row->curve->least[k - PEL_PIECE_MIN_LOG2]))
            return k;
    return 0;
}

/* How many of n pixels from x on, in the block of 64 that holds x, show one
 * colour because they are outside: all or none. Cubics there would show it too,
 * so it does not matter that runs of other ends may cut them otherwise. */
static PEL_WALK int32_t pel_curve_outside(const struct pel_curve_row *row,
                                          int32_t x, int32_t n)
{
    const int32_t size = 1 << PEL_PIECE_MAX_LOG2;
    n = pel_min(n, size - (x & (size - 1)));
    return pel_curve_far(row, pel_curve_way(row, x), 256 * n,
                         row->curve->outside)
               ? n
               : 0;
}

/* With s from 0 to 1 the cubic is a + m s + B s^2 + C s^3, m and n the slopes
 * at a and b per piece, B = 3 (b - a) - 2 m - n, C = m + n - 2 (b - a). In
 * steps of h = 2^-k the differences are m h + B h^2 + C h^3, then 2 B h^2 +
 * 6 C h^3, then 6 C h^3. The shifts lose less than 2^18 units over the piece.
 */
static inline void pel_curve_walk(struct pel_ramp_walk *w,
                                  const struct pel_knot *a,
                                  const struct pel_knot *b, int k)
{
    const int64_t rise = (int64_t)(b->value - a->value);
    const int64_t size = INT64_C(1) << k;
    const int64_t m = a->slope * size, n = b->slope * size;
    const int64_t curve = 3 * rise - 2 * m - n, twist = m + n - 2 * rise;
    w->at = a->value;
    w->d3 = (uint64_t)(6 * twist >> 3 * k);
    w->d2 = (uint64_t)(2 * curve >> 2 * k) + w->d3;
    w->d1 = (uint64_t)(a->slope + (curve >> 2 * k) + (twist >> 3 * k));
}

#endif
