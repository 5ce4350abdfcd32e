#include "fraction.h"

#if !PEL_64BIT || !defined(__GNUC__)

/* The quotient comes into n where its bits go out. */
uint64_t pel_divide_bits(uint64_t n, uint64_t d, int bits, uint64_t *rest)
{
    uint64_t left = *rest;
    for (; bits > 0; bits--) {
        left = left * 2 + (n >> 63);
        n <<= 1;
        if (left >= d) {
            left -= d;
            n |= 1;
        }
    }
    *rest = left;
    return n;
}

/* Of n < 0, all bits turned round are divided and turned back. */
void pel_fraction_start(struct pel_fraction *f, int64_t n, int64_t d)
{
    uint64_t rest = 0;
    f->d = d;
    f->quotient =
        pel_divide_bits((uint64_t)(n < 0 ? ~n : n), (uint64_t)d, 64, &rest);
    f->rest = (int64_t)rest;
    if (n < 0) {
        f->quotient = ~f->quotient;
        f->rest = d - 1 - f->rest;
    }
}

void pel_fraction_more(struct pel_fraction *f, int bits)
{
    uint64_t rest = (uint64_t)f->rest;
    f->quotient =
        (f->quotient << bits) + pel_divide_bits(0, (uint64_t)f->d, bits, &rest);
    f->rest = (int64_t)rest;
}

#endif
