/* Products of numbers of 31, 32 and 64 bits, against the compiler's. */
#include "core/base/point.h"
#include "tests/support/check.h"

enum { LIMIT = 1 << 30 };

/* All that are at most 3 away from a power of two, of both signs. */
static int32_t list_numbers(int32_t *v)
{
    int32_t n = 0;
    for (int bit = 0; bit <= 30; bit++)
        for (int32_t near = -3; near <= 3; near++) {
            const int32_t number = (1 << bit) + near;
            if (number >= LIMIT || number < 0)
                continue;
            v[n++] = number;
            v[n++] = -number;
        }
    return n;
}

TEST(products)
{
    int32_t v[31 * 7 * 2];
    const int32_t n = list_numbers(v);
    for (int32_t i = 0; i < n; i++)
        for (int32_t k = 0; k < n; k++)
            if (pel_product(v[i], v[k]) != (int64_t)v[i] * v[k])
                fail_msg("%d times %d", v[i], v[k]);
}

/* Numbers of all sizes whose bits have no pattern. */
TEST(many_products)
{
    uint64_t seed = 1;
    for (int i = 0; i < 200000; i++) {
        seed = seed * UINT64_C(6364136223846793005) + 1442695040888963407;
        const int32_t a = (int32_t)(seed >> 33) - LIMIT;
        const int32_t b =
            ((int32_t)(seed >> 2 & 0x7FFFFFFF) - LIMIT) >> (i % 31);
        if (a > -LIMIT && b > -LIMIT && pel_product(a, b) != (int64_t)a * b)
            fail_msg("%d times %d", a, b);
    }
}

/* All that are at most 3 away from a power of two, modulo 2^64. */
static uint64_t number_of(int i)
{
    return (UINT64_C(1) << (i / 7 % 64)) + (uint64_t)(i % 7 - 3);
}

TEST(whole_products)
{
    for (int i = 0; i < 64 * 7; i++)
        for (int k = 0; k < 64 * 7; k++) {
            const uint64_t a = number_of(i), b = number_of(k);
            const uint32_t low = (uint32_t)a, word = (uint32_t)b;
            const int32_t n = (int32_t)word;
            if (pel_multiply(low, word) != (uint64_t)low * word)
                fail_msg("%u times %u", low, word);
            if (pel_times(a, n) != a * (uint64_t)(int64_t)n)
                fail_msg("%llu times %d", (unsigned long long)a, n);
            if (pel_long_product((int32_t)low, n) != (int64_t)(int32_t)low * n)
                fail_msg("%d times %d", (int32_t)low, n);
        }
}

/* Gradients of slivers wrap, to -2^63 too. */
TEST(sizes)
{
    assert_int_equal(pel_size_of(-5), 5);
    assert_int_equal((uint64_t)pel_size_of(INT64_MIN), UINT64_C(1) << 63);
}
