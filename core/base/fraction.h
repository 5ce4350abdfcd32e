/* Quotients as binary fractions, digit by digit: for the set-up of planes. */
#ifndef PEL_BASE_FRACTION_H
#define PEL_BASE_FRACTION_H

#include <stdint.h>

#include "inline.h"

/* quotient = floor(n / d 2^bits) modulo 2^64, in two's complement, where bits
 * grow from 0 with every call of more. 0 < d < 2^51, any n. */
struct pel_fraction {
    uint64_t quotient;
    int64_t rest, d;
};

#if PEL_64BIT && defined(__GNUC__)

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
    const int room = __builtin_clzll(d);
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

void pel_fraction_start(struct pel_fraction *f, int64_t n, int64_t d);
void pel_fraction_more(struct pel_fraction *f, int bits);

/* The next `bits` bits of a quotient, modulo 2^64: of n from its upper
 * end, and zeros behind it, after a rest below d, which it changes. What is
 * left of n is 0. Bit by bit, in less code than the compiler's division. d <
 * 2^63. */
uint64_t pel_divide_bits(uint64_t n, uint64_t d, int bits, uint64_t *rest);

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
