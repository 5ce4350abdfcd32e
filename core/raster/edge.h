/* The exact walk of an edge: x(row), the first pixel of every row whose centre
 * lies on the edge or to the right of it.
 *
 * The rule. A pixel belongs to a shape when its centre is inside; a centre that
 * lies exactly on an edge belongs to the shape of which that edge is a top or a
 * left edge. The pixels between two edges of a row are
 * [x(left), x(right)): a centre on the left edge is in, one on the right edge
 * is out, and two shapes that share an edge share the integer, so no pixel of a
 * mesh is missed or hit twice. Rows follow the same rule: those whose centre y
 * satisfies top <= y < bottom.
 *
 * The walk. For an edge from a down to b let dx = b.x - a.x, dy = b.y - a.y,
 * q = floor(dx / dy), r = dx - q dy, and t = (centre of the first row) - a.y,
 * 0 <= t < 256. The edge crosses that row at a.x + t dx / dy, and
 *
 *     x = ceil((a.x + t dx / dy - 128) / 256)
 *       = floor(((a.x - 128 + t q + 256) dy + t r - 1) / (256 dy)).
 *
 * The numerator is A dy + (t r + dy - 1) with A = a.x + 127 + t q. Split A into
 * 256 (A >> 8) + Af. Then x is A >> 8 plus the carry of
 * m = floor((Af dy + t r + dy - 1) / 256) against dy, and since all numerators
 * move by multiples of 256 from row to row (256 q dy + 256 r), the bits that
 * this floor drops never change: nothing is rounded, nothing drifts.
 *
 * Ranges. |dx| < 2^24, 0 < dy < 2^24. t <= dy because the row lies below a and
 * above b, so |t q| <= |dx| + t < 2^25 and A fits 27 bits. 0 <= m < 2 dy: one
 * correction. The sum before that floor takes 33 bits, of which pel_edge_carry
 * keeps the last in a carry. So 32 bits are enough for the full range. */
#ifndef PEL_RASTER_EDGE_H
#define PEL_RASTER_EDGE_H

#include "../base/point.h"

struct pel_edge {
    int32_t x;    /* first pixel on or right of the edge, in this row */
    int32_t m;    /* accumulator less dy: in [-dy, 0) */
    int32_t q, r; /* dx = q dy + r, 0 <= r < dy: the step to the next row */
    int32_t dy;
};

/* floor(dx / dy) and the remainder; dy > 0. */
#if defined(__ARM_ARCH) && !defined(__ARM_FEATURE_IDIV) && !defined(__aarch64__)

/* No divide instruction: subtracts shifted divisors, from the first that fits
 * down, about log2(|dx| / dy) steps, one for |dx| < dy.
 * floor(dx / dy) = ~floor(~dx / dy) for dx < 0. */
static inline int32_t pel_floor_divide(int32_t dx, int32_t dy,
                                       int32_t *remainder)
{
    uint32_t u = (uint32_t)(dx < 0 ? ~dx : dx), d = (uint32_t)dy, q = 0;
    if (u >= d) {
        uint32_t bit = 1;
        for (; d <= u >> 1; d <<= 1)
            bit <<= 1;
        do {
            if (u >= d) {
                u -= d;
                q |= bit;
            }
            d >>= 1;
            bit >>= 1;
        } while (bit);
    }
    *remainder = dx < 0 ? dy - 1 - (int32_t)u : (int32_t)u;
    return dx < 0 ? ~(int32_t)q : (int32_t)q;
}

#else

static inline int32_t pel_floor_divide(int32_t dx, int32_t dy,
                                       int32_t *remainder)
{
    int32_t q = dx / dy, r = dx - q * dy;
    if (r < 0) {
        r += dy;
        q--;
    }
    *remainder = r;
    return q;
}

#endif

/* Moves k >= 0 rows down in about log2(k) turns, by doubling the step. k rows
 * lie inside the edge, so |q| k < 2^17 + k, and the doubling after the last bit
 * of k stays below 2^19. */
static inline void pel_edge_skip(struct pel_edge *e, int32_t k)
{
    int32_t q = e->q, r = e->r;
    for (; k; k >>= 1) {
        if (k & 1) {
            e->x += q;
            e->m += r;
            if (e->m >= 0) {
                e->m -= e->dy;
                e->x++;
            }
        }
        q *= 2;
        r += r - e->dy;
        if (r < 0)
            r += e->dy;
        else
            q++;
    }
}

/* floor((f dy + t r + dy - 1) / 256); 0 <= f, t < 256, 0 <= r < dy < 2^24. Both
 * terms fit 32 bits, their sum 33: (f + 1) dy - 1 < 2^32 and t r < 2^32. */
static inline int32_t pel_edge_carry(int32_t f, int32_t t, int32_t r,
                                     int32_t dy)
{
    const uint32_t a = PEL_CAST(uint32_t, f + 1) * PEL_CAST(uint32_t, dy) - 1;
    const uint32_t sum = a + PEL_CAST(uint32_t, t) * PEL_CAST(uint32_t, r);
    const uint32_t carry = sum < a;
    return PEL_CAST(int32_t, (sum >> 8) + (carry << 24));
}

/* The edge from a down to b, a.y < b.y, at row `top`, which lies on or below
 * the first row of the edge: pel_first_pixel(a.y) <= top <
 * pel_first_pixel(b.y). */
static PEL_SHARED void pel_edge_start(struct pel_edge *e,
                                      const struct pel_point *a,
                                      const struct pel_point *b, int32_t top)
{
    const int32_t row = pel_first_pixel(a->y);
    const int32_t dy = b->y - a->y, t = pel_pixel_center(row) - a->y;
    int32_t r, q = pel_floor_divide(b->x - a->x, dy, &r);
    const int32_t start = a->x + 127 + t * q;
    int32_t x = start >> 8, m = pel_edge_carry(start & 255, t, r, dy) - dy;
    if (m >= 0) {
        m -= dy;
        x++;
    }
    e->x = x;
    e->m = m;
    e->q = q;
    e->r = r;
    e->dy = dy;
    pel_edge_skip(e, top - row);
}

static inline void pel_edge_next(struct pel_edge *e)
{
    int32_t x = e->x + e->q, m = e->m + e->r;
    if (m >= 0) {
        m -= e->dy;
        x++;
    }
    e->x = x;
    e->m = m;
}

#endif
