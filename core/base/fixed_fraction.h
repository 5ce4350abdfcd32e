/* Quotients as binary fractions, digit by digit: for the set-up of planes. */
#ifndef PEL_BASE_FIXED_FRACTION_H
#define PEL_BASE_FIXED_FRACTION_H

#include <stdint.h>

/* quotient = floor(n / d 2^bits) modulo 2^64, in two's complement, where bits
 * grow from 0 with every call of more. 0 < d < 2^51, any n. */
struct pel_fraction {
    uint64_t quotient;
    int64_t rest, d;
};

void pel_fraction_start(struct pel_fraction *f, int64_t n, int64_t d);
void pel_fraction_more(struct pel_fraction *f, int bits);

/* floor(n / d 2^bits) modulo 2^64. */
static inline uint64_t pel_fraction_of(int64_t n, int64_t d, int bits)
{
    struct pel_fraction f;
    pel_fraction_start(&f, n, d);
    pel_fraction_more(&f, bits);
    return f.quotient;
}

#endif
