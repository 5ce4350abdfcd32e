/* The area right of an edge in the pixels of a row, in closed form.
 *
 * An edge whose x moves by w px a row crosses a row from lo to hi, h = 1 high
 * or less where a vertex lies in the row. The area right of it is in the first
 * pixel c(u) = u^2 / 2w, u the way from lo to the pixel's right side; it grows
 * by 1/w from pixel to pixel, beginning with (u + 1/2) / w; in the last pixel
 * it is h - c(v), v the way from the pixel's left side to hi; and h in all
 * pixels further right. A pixel's area is the sum over the left edges less that
 * over the right ones.
 *
 * Areas are in 2^-24 of 1/255 px^2, modulo 2^32: with a HALF to round by, their
 * upper byte is the coverage. 255 and two halves are 2^32, so what lies left of
 * an edge is the negative of what lies right of it.
 *
 * The error of an edge in a pixel, in 1/255, is below .02:
 *  - x of an edge is rounded down to 2^-16 px after a sum of steps that are
 *    each less than 2^-32 px short, over at most 65,536 rows: off by 2 units of
 *    2^-16 px, which are 2 * 255 * 2^-16 = .0078 of the area;
 *  - c is rounded down in products of 16 bits by 16: in u by a unit where it is
 *    halved, in 1/w by 2^-16 of 255 / w, before the second product by a unit:
 *    together below u 2 * 2^16 units of 2^-24, .0078;
 *  - 1/w itself is 1 unit short, less than 65,536 times: .0039.
 * Edges of less than 2^-14 px a row take 1/w as 2^14: what is missing, below
 * u / 2 with u <= w + 2^-15 px, is .01 at most, and the products of the second
 * line are below 2^-10 of it. */
#ifndef PEL_SMOOTH_SMOOTH_EDGE_H
#define PEL_SMOOTH_SMOOTH_EDGE_H

#include "../base/point.h"

PEL_BEGIN_DECLS

#define PEL_SMOOTH_HALF (UINT32_C(1) << 23)
#define PEL_SMOOTH_FULL (UINT32_C(255) << 24)

/* 1/w of an edge. steep, w < 1: 255 2^7 / w; else 255 2^24 / w. */
struct pel_rise {
    uint32_t value;
    bool steep;
};

/* x of a coordinate, px 2^-32. */
static inline int64_t pel_smooth_wide(int32_t x)
{
    return (int64_t)x * (1 << 24);
}

/* What the edge from a down to b moves in a row, px 2^-32, and its rise: 0 and
 * that of an edge of no height. */
int64_t pel_smooth_slope(const struct pel_point *a, const struct pel_point *b,
                         struct pel_rise *rise);

/* 255 c(u); u in 2^-16 px. */
static inline uint32_t pel_smooth_corner(const struct pel_rise *rise,
                                         uint32_t u)
{
    if (rise->steep)
        return (u * rise->value >> 16) * u;
    return ((u >> 1) * (rise->value >> 16) >> 16) * u;
}

/* 255 (u + 1/2) / w; not of a steep edge. */
static inline uint32_t pel_smooth_between(const struct pel_rise *rise,
                                          uint32_t u)
{
    u >>= 1;
    return (rise->value >> 1) + (u * (rise->value >> 16) << 1) +
           (u * (rise->value >> 8 & 255) >> 7);
}

/* What an edge is in a row: from where to where it crosses it, in order of x,
 * and how much of its height. */
struct pel_smooth_piece {
    int32_t lo, hi; /* px 2^-16 */
    struct pel_rise rise;
    uint32_t height; /* px 2^-16 */
};

/* Sets where it begins and ends, given both in any order. */
static inline void pel_smooth_piece_set(struct pel_smooth_piece *p, int32_t a,
                                        int32_t b)
{
    p->lo = pel_min(a, b);
    p->hi = pel_max(a, b);
}

/* 255 times the area right of a piece in a pixel that it crosses. */
static inline uint32_t pel_smooth_area_in(const struct pel_smooth_piece *p,
                                          int32_t x)
{
    const int32_t a = p->lo >> 16, b = p->hi >> 16;
    const uint32_t low = p->lo & 0xFFFF, high = p->hi & 0xFFFF;
    const uint32_t full = p->height * (255 << 8);
    if (a == b)
        return full - ((low + high) * (p->height >> 1) >> 8) * 255;
    if (x == a)
        return pel_smooth_corner(&p->rise, 65536 - low);
    if (x == b)
        return full - pel_smooth_corner(&p->rise, high);
    return pel_smooth_between(&p->rise, 65536 - low) +
           (uint32_t)(x - a - 1) * p->rise.value;
}

/* Adds 255 times the area right of a piece in n pixels from x on; takes it away
 * where flip is all ones. */
void pel_smooth_add(const struct pel_smooth_piece *piece, uint32_t flip,
                    int32_t x, int32_t n, uint32_t *area);

PEL_END_DECLS
#endif
