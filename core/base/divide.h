/* Division of 64 bits. 64-bit CPUs divide inline; others have functions that
 * are shorter, and take less stack, than the compiler's. */
#ifndef PEL_BASE_DIVIDE_H
#define PEL_BASE_DIVIDE_H

#include <stdbool.h>

#include "inline.h"

/* Where stack is short it may lie in a struct that is aligned to 4. */
#if (PEL_SHORT_STACK || PEL_SMALL_CODE) && defined(__GNUC__)
typedef int64_t pel_dividend __attribute__((__aligned__(4)));
#else
typedef int64_t pel_dividend;
#endif

/* pel_divide: floor(n / d); d > 0, n < d 2^32. pel_divide_64: floor(n / d), and
 * n becomes the remainder, 0 or more; d > 0. pel_divide_fraction: floor(n 2^32
 * / d), and `fine`, floor(n 2^24 / d), modulo 2^64; 0 < d < 2^63. */
#if PEL_64BIT

static inline uint32_t pel_divide(uint64_t n, uint32_t d)
{
    return (uint32_t)(n / d);
}

static inline int64_t pel_divide_64(pel_dividend *n, int64_t d)
{
    const int64_t rest = *n % d, quotient = *n / d;
    *n = rest < 0 ? rest + d : rest;
    return quotient - (rest < 0);
}

/* Of most triangles n fits 32 bits: one division. Otherwise as many bits at a
 * time as the remainder has room for. */
static inline uint64_t pel_divide_fraction(uint64_t n, uint64_t d,
                                           uint64_t *fine)
{
    const int room = pel_leading_zeros(d);
    uint64_t q;
    if (n >> 32 == 0) {
        q = (n << 32) / d;
        *fine = q >> 8;
        return q;
    }
    q = n / d;
    *fine = q << 24;
    for (int bits = 32, digit; bits > 0; bits -= digit) {
        digit = bits < room ? bits : room;
        n = n % d << digit;
        q = (q << digit) + n / d;
    }
    *fine += (uint32_t)q >> 8;
    return q;
}

#else

uint32_t pel_divide(uint64_t n, uint32_t d);
int64_t pel_divide_64(pel_dividend *n, int64_t d);
uint64_t pel_divide_fraction(uint64_t n, uint64_t d, uint64_t *fine);

#endif
#endif
