#include "divide.h"

#if PEL_64BIT
/* In the header. */
#elif PEL_LONG_MULTIPLY

/* In less stack than the compiler's division of all sizes. With d brought to
 * its highest bit, a digit of 16 bits that is guessed from the upper half of d
 * alone is at most 2 too large. */
uint32_t pel_divide(uint64_t n, uint32_t d)
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

#else

/* Bit by bit, in less code than the compiler's division of all sizes. `high` is
 * the rest, below d; what leaves it on the left is worth 2^32. */
uint32_t pel_divide(uint64_t n, uint32_t d)
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

#endif
