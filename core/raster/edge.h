/* The exact edge walk: for every row, the first pixel whose centre lies on an
 * edge or to the right of it.
 *
 * The rule. A pixel belongs to a shape when its centre is inside; a centre that
 * lies exactly on an edge belongs to the shape of which that edge is a top or a
 * left edge. With x(row) as above for both edges of a row, the pixels are
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
 * Split A = a.x - 128 + t q + 256 into 256 (A >> 8) + Af. Then x is A >> 8 plus
 * the carry of m = floor((Af dy + t r - 1) / 256) against dy, and since all
 * numerators move by multiples of 256 from row to row (256 q dy + 256 r), the
 * bits that this floor drops never change: nothing is rounded, nothing drifts.
 *
 * Ranges. |dx| < 2^24, 0 < dy < 2^24. t <= dy because the row lies below a and
 * above b, so |t q| <= |dx| + t < 2^25 and A fits 27 bits. m >= -1 and
 * m < dy + r < 2 dy: one correction. m is computed in parts of 8 and 16 bits:
 * Af (dy >> 8) and t (r >> 8) are below 2^24, Af (dy & 255) + t (r & 255) below
 * 2^17. So 32 bits carry the full range. */
#ifndef PEL_RASTER_EDGE_H
#define PEL_RASTER_EDGE_H

#include "../base/fixed.h"
#include "../pel_config.h"

struct pel_edge {
    int32_t x;    /* first pixel on or right of the edge, in this row */
    int32_t m;    /* accumulator less dy: in [-dy, 0) */
    int32_t q, r; /* dx = q dy + r, 0 <= r < dy: the step to the next row */
    int32_t dy;
};

/* floor(dx / dy) and the remainder. |dx| < dy needs no division. A CPU that
 * cannot divide subtracts shifted divisors, from the first that fits down:
 * about log2(|dx| / dy) steps. floor(dx / dy) = ~floor(~dx / dy) for dx < 0. */
static inline int32_t pel_floor_divide(int32_t dx, int32_t dy,
                                       int32_t *remainder)
{
    uint32_t u = (uint32_t)(dx < 0 ? ~dx : dx), d = (uint32_t)dy, q = 0;
    if (u >= d) {
#if defined(__ARM_ARCH) && !defined(__ARM_FEATURE_IDIV)
        uint32_t bit = 1;
        for (; d <= u >> 1; d <<= 1)
            bit <<= 1;
        for (; bit; bit >>= 1, d >>= 1)
            if (u >= d) {
                u -= d;
                q |= bit;
            }
#else
        q = u / d;
        u -= q * d;
#endif
    }
    *remainder = dx < 0 ? dy - 1 - (int32_t)u : (int32_t)u;
    return dx < 0 ? ~(int32_t)q : (int32_t)q;
}

/* Moves k >= 0 rows down without walking them: k is added up from doubled
 * steps. k rows lie inside the edge, so |q| k < 2^17 + k, and the doubling that
 * comes after the last bit of k stays below 2^19. */
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

/* The edge from a down to b, a.y < b.y, at row `top`, which lies on or below
 * the first row of the edge: pel_first_pixel(a.y) <= top <
 * pel_first_pixel(b.y). */
static inline void pel_edge_start(struct pel_edge *e, const struct pel_point *a,
                                  const struct pel_point *b, int32_t top)
{
    const int32_t row = pel_first_pixel(a->y);
    const int32_t dy = b->y - a->y, t = pel_pixel_center(row) - a->y;
    int32_t r, q = pel_floor_divide(b->x - a->x, dy, &r);
    const int32_t start = a->x - 128 + t * q + 256, fraction = start & 255;
    int32_t m = fraction * (dy >> 8) + t * (r >> 8) - dy +
                ((fraction * (dy & 255) + t * (r & 255) - 1) >> 8);
    int32_t x = start >> 8;
    if (m < -dy) {
        m += dy;
        x--;
    } else if (m >= 0) {
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
    e->x += e->q;
    e->m += e->r;
    if (e->m >= 0) {
        e->m -= e->dy;
        e->x++;
    }
}

#endif
