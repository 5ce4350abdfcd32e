/* Steps of square roots, for sqrt.c and inverse_root.c. */
#ifndef PEL_BASE_ROOT_STEPS_H
#define PEL_BASE_ROOT_STEPS_H

#include "point.h"

/* 2^15 / sqrt(i / 64), i from 16 to 64. */
extern const uint16_t pel_root_table[49];

/* Half the shift that brings v, not 0, to [2^60, 2^62). */
#if defined(__GNUC__) && PEL_LONG_MULTIPLY

static inline int pel_root_half_shift(uint64_t v)
{
    return (__builtin_clzll(v) - 2) / 2;
}

#else

static inline int pel_root_half_shift(uint64_t v)
{
    int shift = 0;
    for (; v < UINT64_C(1) << 60; v <<= 2)
        shift++;
    return shift;
}

#endif

/* 2^31 / sqrt(m / 2^32), 2^30 <= m < 2^32: the table, linear between its values
 * (off by 2^-11.5), then one step of Newton's iteration y (3 - m y^2) / 2,
 * which leaves 3/2 of the square of that. */
static inline uint32_t pel_root_inverse(uint32_t m)
{
    const uint16_t *t = &pel_root_table[(m >> 26) - 16];
    uint32_t y =
        t[0] * UINT32_C(65536) - (uint32_t)(t[0] - t[1]) * (m >> 10 & 0xFFFF);
    uint32_t square = (uint32_t)(pel_multiply(y, y) >> 32);
    uint32_t one = (uint32_t)(pel_multiply(square, m) >> 32);
    uint64_t next = pel_multiply(y, UINT32_C(3221225472) - one) >> 31;
    return next > UINT32_MAX ? UINT32_MAX : (uint32_t)next;
}

#endif
