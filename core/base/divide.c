#include "divide.h"

#if !PEL_64BIT

/* With d brought to
 * its highest bit, a digit of 16 bits that is guessed from the upper half of d
 * alone is at most 2 too large. */
static inline uint32_t divide_by_digits(uint64_t n, uint32_t d)
{
    for (; d < UINT32_C(0x80000000); d <<= 1)
        n <<= 1;
    const uint32_t high = d >> 16, low = d & 0xFFFF;
    uint32_t rest = (uint32_t)(n >> 32), next = (uint32_t)n, quotient = 0;
    for (int digit = 0; digit < 2; digit++, next <<= 16) {
        uint32_t q = rest / high, r = rest - q * high;
        while (r < 65536 && (q > 65535 || q * low > (r << 16 | next >> 16))) {
            q--;
            r += high;
        }
        rest = (rest << 16 | next >> 16) - q * d;
        quotient = quotient << 16 | q;
    }
    return quotient;
}

/* In the least code. `high` is the rest, below d; the bit that leaves it on the
 * left is worth 2^32. */
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
    uint64_t rest;
    f->d = d;
    f->quotient = pel_divide_64((uint64_t)(n < 0 ? ~n : n), (uint64_t)d, &rest);
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
