/* Positions along a ramp, four pixels at a time, in 32 bits: what the highest
 * bits of a walk's say, nearly always. For ramp_vector_*.c and patch*.c. */
#ifndef PEL_PAINT_RAMP_LANES_H
#define PEL_PAINT_RAMP_LANES_H

#include <stddef.h>

#include "ramp_vector_lanes.h"
#include "ramp_walk.h"

#if PEL_FAST_64BIT && PEL_VECTORS

/* Four pixels' positions in 2^-32 of the way, rounded down, and differences
 * from one four to the next, rounded down too. After s steps, s < 16, a
 * position is too small by less than 1 + s + s (s - 1) / 2 + s (s - 1) (s - 2)
 * / 6 <= 576 units. So what its bits and those of 576 more agree on is what the
 * walk of 64 bits says; where they do not agree that walk has to be asked, for
 * one of 29,000 pixels at 256 cells. */
struct pel_lanes {
    pel_u32x4 at, d1, d2, d3;
};

enum { PEL_LANES_ERROR = 576 };

/* The upper words of pixels 0 and 2, and 1 and 3. */
static PEL_ALWAYS_INLINE pel_u32x4 pel_lanes_high(pel_u64x2 even, pel_u64x2 odd)
{
    return (pel_u32x4)(even >> 32 | (odd >> 32) << 32);
}

/* A difference over four pixels is (1 + D)^4 - 1 with D that over one: 4 D + 6
 * D^2 + 4 D^3; twice 16 D^2 + 48 D^3; three times 64 D^3. The walk has 64 bits.
 */
static PEL_ALWAYS_INLINE struct pel_lanes pel_lanes_of(
    const struct pel_ramp_walk *w, int shift)
{
    const uint64_t at = w->at << shift, d1 = w->d1 << shift;
    const uint64_t d2 = w->d2 << shift, d3 = w->d3 << shift, turn = d2 + d3;
    const uint64_t at1 = at + d1, at2 = at1 + d1 + d2;
    const uint64_t at3 = at2 + d1 + d2 + turn;
    const uint64_t by0 = (d1 + turn) * 4 + d2 * 2, more = turn * 4 + d3 * 2;
    const uint64_t by1 = by0 + more, by2 = by1 + more + d3 * 4;
    const uint64_t by3 = by2 + more + d3 * 8, bend = d2 * 16 + d3 * 48;
    const pel_u64x2 bends = {bend, bend + d3 * 32}, step = {d3 * 16, d3 * 16};
    const uint32_t last = (uint32_t)(d3 >> 26);
    struct pel_lanes l;
    l.at = pel_lanes_high((pel_u64x2){at, at2}, (pel_u64x2){at1, at3});
    l.d1 = pel_lanes_high((pel_u64x2){by0, by2}, (pel_u64x2){by1, by3});
    l.d2 = pel_lanes_high(bends, bends + step);
    l.d3 = (pel_u32x4){last, last, last, last};
    return l;
}

/* The positions of the next four pixels. */
static PEL_ALWAYS_INLINE pel_u32x4 pel_lanes_next(struct pel_lanes *l)
{
    const pel_u32x4 at = l->at;
    l->at += l->d1;
    l->d1 += l->d2;
    l->d2 += l->d3;
    return at;
}

/* The pixels of a rectangle, whose positions are a polynomial of degree 3 in x
 * and y: the lanes of its first row, and their first three differences from row
 * to row (of which the second has no d2, the third no d1).
 *
 * All are rounded down: after v rows, v < 16, and s steps, s < 8, a position is
 * too small by less than 1 + v + v (v - 1) / 2 + v (v - 1) (v - 2) / 6 for
 * `at`, (1 + v + v (v - 1) / 2) s for d1, (1 + v) s (s - 1) / 2 for d2, and
 * s (s - 1) (s - 2) / 6 for d3: 1,794 units. */
struct pel_grid {
    struct pel_lanes row[4];
    int32_t width, rows; /* 8, 16 or 32; 1 to 16 */
    uint32_t error;      /* a position is too small by less than this */
    bool padded;         /* positions are in 2^-30 of a padded way, below 2 */
    pel_color *out;
    ptrdiff_t stride; /* of `out`, in colours */

    /* Fours of pixels whose colours may be wrong, and where they begin. */
    int32_t doubts;
    struct {
        uint8_t u, v;
    } doubt[128];
};

enum { PEL_GRID_WIDTH = 32, PEL_GRID_ROWS = 16, PEL_GRID_ERROR = 1794 };

static PEL_ALWAYS_INLINE void pel_grid_next(struct pel_grid *g)
{
    struct pel_lanes *const row = g->row;
    row[0].at += row[1].at;
    row[0].d1 += row[1].d1;
    row[0].d2 += row[1].d2;
    row[1].at += row[2].at;
    row[1].d1 += row[2].d1;
    row[2].at += row[3].at;
}

static inline void pel_grid_doubt(struct pel_grid *g, int32_t u, int32_t v)
{
    g->doubt[g->doubts].u = (uint8_t)u;
    g->doubt[g->doubts++].v = (uint8_t)v;
}

#endif
#endif
