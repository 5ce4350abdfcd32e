#include "point.h"

#if !PEL_LONG_MULTIPLY

/* By halves of 16 bits, the upper ones signed and below 2^14: so the sum in the
 * middle is below 2^31. */
int64_t pel_product(int32_t a, int32_t b)
{
    const uint32_t a0 = (uint32_t)a & 0xFFFF, b0 = (uint32_t)b & 0xFFFF;
    const int32_t a1 = a >> 16, b1 = b >> 16;
    const int32_t middle = a1 * (int32_t)b0 + (int32_t)a0 * b1;
    const uint32_t low = a0 * b0, sum = low + ((uint32_t)middle << 16);
    const int32_t high = a1 * b1 + (middle >> 16) + (sum < low);
    return (int64_t)((uint64_t)(uint32_t)high << 32 | sum);
}

#endif
