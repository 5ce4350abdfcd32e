#include "fixed_divide.h"

#if PEL_FAST_64BIT
/* In the header. */
#elif PEL_LONG_MULTIPLY

uint32_t pel_divide(uint64_t n, uint32_t d)
{
    return (uint32_t)(n / d);
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
