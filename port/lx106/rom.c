/* Products and quotients that an ESP8266 has in its ROM, and Debian's libgcc
 * for its CPU does not: it multiplies 16 bits by 16 and 32 by 32 to 32, and
 * knows no division. Their bits are found one by one, as those of the ROM are.
 */
#include <stdint.h>

/* Calls of it may come from the compiler's last stage, with -flto too. */
#define ROM __attribute__((used))

ROM uint64_t __umulsidi3(uint32_t a, uint32_t b);
uint64_t __umulsidi3(uint32_t a, uint32_t b)
{
    const uint32_t a0 = a & 0xFFFF, a1 = a >> 16;
    const uint32_t b0 = b & 0xFFFF, b1 = b >> 16;
    const uint32_t low = a0 * b0;
    /* <= 65535^2 + 65535 < 2^32, and so is the sum with 65535 more */
    const uint32_t middle = a1 * b0 + (low >> 16);
    const uint32_t other = a0 * b1 + (middle & 0xFFFF);
    const uint32_t high = a1 * b1 + (middle >> 16) + (other >> 16);
    return (uint64_t)high << 32 | other << 16 | (low & 0xFFFF);
}

ROM uint64_t __muldi3(uint64_t a, uint64_t b);
uint64_t __muldi3(uint64_t a, uint64_t b)
{
    const uint32_t x = (uint32_t)a, y = (uint32_t)b;
    const uint32_t high = (uint32_t)(a >> 32) * y + x * (uint32_t)(b >> 32);
    return __umulsidi3(x, y) + ((uint64_t)high << 32);
}

/* Of d = 0 anything. */
static uint32_t divide(uint32_t n, uint32_t d, uint32_t *rest)
{
    uint32_t quotient = 0;
    int i = n < d || !d ? -1 : __builtin_clz(d) - __builtin_clz(n);
    for (; i >= 0; i--)
        if (n >= d << i) {
            n -= d << i;
            quotient |= UINT32_C(1) << i;
        }
    *rest = n;
    return quotient;
}

static int leading_zeros(uint64_t n)
{
    return n >> 32 ? __builtin_clz((uint32_t)(n >> 32))
                   : 32 + __builtin_clz((uint32_t)n);
}

static uint64_t divide_long(uint64_t n, uint64_t d, uint64_t *rest)
{
    uint64_t quotient = 0;
    int i = n < d || !d ? -1 : leading_zeros(d) - leading_zeros(n);
    for (; i >= 0; i--)
        if (n >= d << i) {
            n -= d << i;
            quotient |= UINT64_C(1) << i;
        }
    *rest = n;
    return quotient;
}

ROM uint64_t __udivdi3(uint64_t n, uint64_t d);
uint64_t __udivdi3(uint64_t n, uint64_t d)
{
    uint64_t rest;
    return divide_long(n, d, &rest);
}

ROM uint64_t __umoddi3(uint64_t n, uint64_t d);
uint64_t __umoddi3(uint64_t n, uint64_t d)
{
    uint64_t rest;
    divide_long(n, d, &rest);
    return rest;
}

ROM int64_t __divdi3(int64_t n, int64_t d);
int64_t __divdi3(int64_t n, int64_t d)
{
    const uint64_t q = __udivdi3(n < 0 ? 0 - (uint64_t)n : (uint64_t)n,
                                 d < 0 ? 0 - (uint64_t)d : (uint64_t)d);
    return (int64_t)((n ^ d) < 0 ? 0 - q : q);
}

ROM uint32_t __udivsi3(uint32_t n, uint32_t d);
uint32_t __udivsi3(uint32_t n, uint32_t d)
{
    uint32_t rest;
    return divide(n, d, &rest);
}

ROM uint32_t __umodsi3(uint32_t n, uint32_t d);
uint32_t __umodsi3(uint32_t n, uint32_t d)
{
    uint32_t rest;
    divide(n, d, &rest);
    return rest;
}

ROM int32_t __divsi3(int32_t n, int32_t d);
int32_t __divsi3(int32_t n, int32_t d)
{
    const uint32_t q = __udivsi3(n < 0 ? 0 - (uint32_t)n : (uint32_t)n,
                                 d < 0 ? 0 - (uint32_t)d : (uint32_t)d);
    return (int32_t)((n ^ d) < 0 ? 0 - q : q);
}
