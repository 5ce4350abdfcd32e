#include "divide.h"

#if !PEL_64BIT

/* Subtracts shifted divisors, from the first that fits down. */
uint64_t pel_divide_64(uint64_t n, uint64_t d, uint64_t *rest)
{
    uint64_t quotient = 0;
    int shift = 0;
    for (; d <= n >> 1; d <<= 1)
        shift++;
    for (; shift >= 0; shift--, d >>= 1) {
        quotient <<= 1;
        if (n >= d) {
            n -= d;
            quotient++;
        }
    }
    *rest = n;
    return quotient;
}

#endif
