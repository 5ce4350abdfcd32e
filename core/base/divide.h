/* Division of 64 bits. 64-bit CPUs divide inline; others have functions that
 * are shorter, and take less stack, than the compiler's. */
#ifndef PEL_BASE_DIVIDE_H
#define PEL_BASE_DIVIDE_H

#include "inline.h"

/* A quotient as a binary fraction, digit by digit: floor(n / d 2^bits) modulo
 * 2^64, in two's complement, where bits grow from 0 with every call of
 * pel_fraction_more. 0 < d < 2^51, any n. */
struct pel_fraction {
    uint64_t quotient;
    int64_t rest, d;
};

/* The next `bits` bits of a quotient, modulo 2^64: of n from its upper end, and
 * zeros behind it, after a rest below d, which it changes. The rest of n is 0.
 * d < 2^63. */
uint64_t pel_divide_bits(uint64_t n, uint64_t d, int bits, uint64_t *rest);

#if PEL_64BIT

/* floor(n / d); d > 0, n < d 2^32. */
static inline uint32_t pel_divide(uint64_t n, uint32_t d)
{
    return (uint32_t)(n / d);
}

/* floor(n / d) and the remainder; d > 0. */
static inline uint64_t pel_divide_64(uint64_t n, uint64_t d, uint64_t *rest)
{
    *rest = n % d;
    return n / d;
}

/* Without a branch on the sign, which cannot be predicted. */
static inline void pel_fraction_start(struct pel_fraction *f, int64_t n,
                                      int64_t d)
{
    const int64_t rest = n % d, below = -(int64_t)(rest < 0);
    f->d = d;
    f->quotient = (uint64_t)(n / d + below);
    f->rest = rest + (d & below);
}

/* As many bits at a time as the rest, which is below d, has room for: 13 at
 * least, and 32 where d fits 32 bits. */
static inline void pel_fraction_more(struct pel_fraction *f, int bits)
{
    const uint64_t d = (uint64_t)f->d;
    const int room = pel_leading_zeros(d);
    uint64_t rest = (uint64_t)f->rest;
    for (int digit; bits > 0; bits -= digit) {
        digit = bits < room ? bits : room;
        rest <<= digit;
        f->quotient = (f->quotient << digit) + rest / d;
        rest %= d;
    }
    f->rest = (int64_t)rest;
}

#else

uint32_t pel_divide(uint64_t n, uint32_t d);
uint64_t pel_divide_64(uint64_t n, uint64_t d, uint64_t *rest);
void pel_fraction_start(struct pel_fraction *f, int64_t n, int64_t d);
void pel_fraction_more(struct pel_fraction *f, int bits);

#endif

/* floor(n / d 2^bits) modulo 2^64. */
static inline uint64_t pel_fraction_of(int64_t n, int64_t d, int bits)
{
    struct pel_fraction f;
    pel_fraction_start(&f, n, d);
    pel_fraction_more(&f, bits);
    return f.quotient;
}

#endif
