#include "fraction.h"

#if !PEL_FAST_64BIT || !defined(__GNUC__)

void pel_fraction_start(struct pel_fraction *f, int64_t n, int64_t d)
{
    f->d = d;
    f->quotient = (uint64_t)(n / d);
    f->rest = n % d;
    if (f->rest < 0) {
        f->rest += d;
        f->quotient--;
    }
}

/* A rest below 2^51 and a digit of 12 bits fit 63 bits. */
void pel_fraction_more(struct pel_fraction *f, int bits)
{
    for (int digit; bits > 0; bits -= digit) {
        digit = bits < 12 ? bits : 12;
        f->rest *= (int64_t)1 << digit;
        f->quotient = (f->quotient << digit) + (uint64_t)(f->rest / f->d);
        f->rest %= f->d;
    }
}

#endif
