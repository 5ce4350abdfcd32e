#include "divide.h"

#if !PEL_64BIT

/* Two digits of 16 bits. With d shifted until its highest bit is set, a digit
 * that is guessed from the upper half of d alone is at most 2 too large. */
static inline uint32_t divide_by_digits(uint64_t n, uint32_t d)
{
    for (; d < UINT32_C(0x80000000); d <<= 1)
        n <<= 1;
    const uint32_t high = d >> 16, low = d & 0xFFFF;
    uint32_t remainder = (uint32_t)(n >> 32), next = (uint32_t)n, quotient = 0;
    for (int digit = 0; digit < 2; digit++, next <<= 16) {
        uint32_t q = remainder / high, r = remainder - q * high;
        while (r < 65536 && (q > 65535 || q * low > (r << 16 | next >> 16))) {
            q--;
            r += high;
        }
        remainder = (remainder << 16 | next >> 16) - q * d;
        quotient = quotient << 16 | q;
    }
    return quotient;
}

/* A bit at a time, which is the least code. `high` is the remainder, below d;
 * the bit that is shifted out of it is worth 2^32. */
static inline uint32_t divide_by_bits(uint64_t n, uint32_t d)
{
    uint32_t high = (uint32_t)(n >> 32), low = (uint32_t)n;
    for (int bit = 0; bit < 32; bit++) {
        const uint32_t out = high >> 31;
        high = high << 1 | low >> 31;
        low <<= 1;
        if (out || high >= d) {
            high -= d;
            low |= 1;
        }
    }
    return low;
}

uint32_t pel_divide(uint64_t n, uint32_t d)
{
    return PEL_LONG_MULTIPLY ? divide_by_digits(n, d) : divide_by_bits(n, d);
}

/* Subtracts shifted divisors, the largest that fits first, and then doubles the
 * remainder for 32 bits more. Never inlined, as in one file with its caller:
 * gcc would not see there that *fine is always set. */
PEL_NOINLINE uint64_t pel_divide_fraction(uint64_t n, uint64_t d,
                                          uint64_t *fine)
{
    uint64_t q = 0;
    int bits = 32;
    for (; d <= n >> 1; d <<= 1)
        bits++;
    for (; bits >= 0; bits--) {
        q *= 2;
        if (n >= d) {
            n -= d;
            q++;
        }
        if (bits == 8)
            *fine = q;
        if (bits > 32)
            d >>= 1;
        else
            n *= 2;
    }
    return q;
}

/* Bit by bit. Where n is below 0, floor(n / d) is ~floor((-1 - n) / d). */
int64_t pel_divide_64(pel_dividend *n, int64_t d)
{
    const int64_t sign = *n >> 63;
    int64_t quotient = 0, rest = *n ^ sign, step = d;
    int shift = 0;
    for (; step <= rest >> 1; step *= 2)
        shift++;
    for (; shift >= 0; shift--, step >>= 1) {
        quotient *= 2;
        if (rest >= step) {
            rest -= step;
            quotient++;
        }
    }
    *n = sign ? d - 1 - rest : rest;
    return quotient ^ sign;
}

#endif
