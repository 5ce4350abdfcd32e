#include "multiply.h"

#if !PEL_LONG_MULTIPLY

/* By halves of 16 bits, the upper ones signed and below 2^14: so the sum in the
 * middle, with what is carried into it, is below 2^31. */
int64_t pel_product(int32_t a, int32_t b)
{
    const uint32_t a0 = (uint32_t)a & 0xFFFF, b0 = (uint32_t)b & 0xFFFF;
    const int32_t a1 = a >> 16, b1 = b >> 16;
    const uint32_t ends = a0 * b0;
    const int32_t middle =
        a1 * (int32_t)b0 + (int32_t)a0 * b1 + (int32_t)(ends >> 16);
    const int32_t high = a1 * b1 + (middle >> 16);
    const uint32_t low = (uint32_t)middle << 16 | (ends & 0xFFFF);
    return (int64_t)((uint64_t)(uint32_t)high << 32 | low);
}

/* Not inlined below, where registers are few. */
PEL_NOINLINE uint64_t pel_times(uint64_t a, int32_t n)
{
    const uint32_t low = (uint32_t)a, high = (uint32_t)(a >> 32);
    const uint32_t sum = high * (uint32_t)n - (n < 0 ? low : 0);
    return pel_multiply(low, (uint32_t)n) + ((uint64_t)sum << 32);
}

int64_t pel_dot(const int32_t a[3], const int32_t b[3])
{
    return pel_long_product(a[0], b[0]) + pel_long_product(a[1], b[1]) +
           pel_long_product(a[2], b[2]);
}

int pel_bits_of(uint64_t v)
{
    int bits = 0;
    for (; v >> 32; bits += 8)
        v >>= 8;
    for (uint32_t low = (uint32_t)v; low; low >>= 1)
        bits++;
    return bits;
}

/* By halves of 16 bits: the sum in the middle may leave a carry. */
uint64_t pel_multiply(uint32_t a, uint32_t b)
{
    const uint32_t a0 = a & 0xFFFF, a1 = a >> 16;
    const uint32_t b0 = b & 0xFFFF, b1 = b >> 16;
    const uint32_t one = a0 * b1, middle = a1 * b0 + (a0 * b0 >> 16);
    const uint32_t sum = one + middle;
    const uint32_t high = a1 * b1 + (sum >> 16) + ((uint32_t)(sum < one) << 16);
    return (uint64_t)high << 32 | a * b;
}

#endif
