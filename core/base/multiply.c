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

/* By halves of 16 bits: no sum of a product and the upper half of another, or
 * the lower half of a sum, leaves a carry. Compilers do it in two registers
 * more than Thumb-1 has without the stack. */
#if PEL_FEW_REGISTERS && defined(__GNUC__) && __ARM_ARCH >= 6
uint64_t pel_multiply(uint32_t a, uint32_t b)
{
    register uint32_t x __asm__("r0") = a;
    register uint32_t y __asm__("r1") = b;
    register uint32_t high __asm__("r2"), c __asm__("r3"), d __asm__("r4");
    register uint32_t low __asm__("r12");
    __asm__(".syntax unified\n\t"
            "movs %2, %0\n\t"
            "muls %2, %1, %2\n\t"
            "mov %3, %2\n\t"
            "lsrs %2, %1, #16\n\t"
            "lsrs %4, %0, #16\n\t"
            "uxth %1, %1\n\t"
            "uxth %0, %0\n\t"
            "movs %5, %0\n\t"
            "muls %5, %1, %5\n\t"
            "lsrs %5, %5, #16\n\t"
            "muls %1, %4, %1\n\t"
            "adds %5, %5, %1\n\t"
            "muls %0, %2, %0\n\t"
            "muls %2, %4, %2\n\t"
            "lsrs %1, %5, #16\n\t"
            "adds %2, %2, %1\n\t"
            "uxth %5, %5\n\t"
            "adds %0, %0, %5\n\t"
            "lsrs %0, %0, #16\n\t"
            "adds %2, %2, %0"
            : "+l"(x), "+l"(y), "=&l"(high), "=&r"(low), "=&l"(c), "=&l"(d)
            :
            : "cc");
    return (uint64_t)high << 32 | low;
}
#else
uint64_t pel_multiply(uint32_t a, uint32_t b)
{
    const uint32_t a0 = a & 0xFFFF, a1 = a >> 16;
    const uint32_t b0 = b & 0xFFFF, b1 = b >> 16;
    const uint32_t middle = a1 * b0 + (a0 * b0 >> 16);
    const uint32_t sum = a0 * b1 + (middle & 0xFFFF);
    const uint32_t high = a1 * b1 + (middle >> 16) + (sum >> 16);
    return (uint64_t)high << 32 | a * b;
}
#endif

#endif
