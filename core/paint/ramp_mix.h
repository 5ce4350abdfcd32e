/* Positions along a ramp to cells, and the cells of a ramp of two colours. */
#ifndef PEL_PAINT_RAMP_MIX_H
#define PEL_PAINT_RAMP_MIX_H

#include "../base/color.h"
#include "../pel_config.h"

/* The cell of a position given in 2^-32 of the way, of `cells` < 2^15: both
 * forms are floor(at cells / 2^32). */
static inline uint32_t pel_ramp_cell(uint32_t at, uint32_t cells)
{
#if PEL_LONG_MULTIPLY
    return (uint32_t)((uint64_t)at * cells >> 32);
#else
    return ((at >> 16) * cells + ((at & 0xFFFFu) * cells >> 16)) >> 16;
#endif
}

/* Two channels of a ramp of two colours, in the halves of a word: 255 a and
 * b - a. 255 a + (b - a) cell is between 0 and 255^2 in each half, so nothing
 * is left over between them, though b - a may be negative. */
struct pel_pair {
    uint32_t from, way;
};

static inline struct pel_pair pel_pair_of(uint32_t a, uint32_t b)
{
    a &= 0xFF00FFu;
    b &= 0xFF00FFu;
    return (struct pel_pair){a * 255, b - a};
}

/* pel_round_div255 of both halves. */
static inline uint32_t pel_pair_at(struct pel_pair p, uint32_t cell)
{
    uint32_t t = p.from + p.way * cell + UINT32_C(0x800080);
    return (t + (t >> 8 & 0xFF00FFu)) >> 8 & 0xFF00FFu;
}

#endif
