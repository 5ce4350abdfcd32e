/* The numbers under the paints: square roots, quotients. */
#include "core/base/divide.h"
#include "core/base/sqrt.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"
#include "tests/support/paint_math.h"

static void check_root(uint64_t v)
{
    struct pel_root r;
    pel_square_root(v, &r);
    uint64_t g = r.root;
    if (g * g > v || (g + 1) * (g + 1) <= v)
        fail_msg("the root of %llu is not %llu", (unsigned long long)v,
                 (unsigned long long)g);
    if (v == 0)
        return;
    real exact = 1 / real_root((real)v);
    for (int i = 0; i < 62 - r.shift; i++)
        exact *= 2;
    if (real_abs(exact - r.inverse) > exact / 4194304)
        fail_msg("root of %llu: inverse %u 2^%d", (unsigned long long)v,
                 r.inverse, r.shift - 62);
}

/* All small numbers, and squares with their neighbours of every size. */
TEST(roots)
{
    for (uint64_t v = 0; v < 300000; v++)
        check_root(v);
    for (struct cases c = cases_of(1000000); cases_next(&c);) {
        uint64_t g = random_word(&c.random) >> (1 + c.next % 31);
        check_root(g * g);
        if (g == 0)
            continue;
        check_root(g * g - 1);
        check_root(g * g + 2 * g);
        check_root(g * g + random_word(&c.random) % (2 * g + 1));
    }
    check_root((UINT64_C(1) << 62) - 1);
}

static uint64_t random_long(struct random *r, int bits)
{
    const uint64_t v = (uint64_t)random_word(r) << 32 | random_word(r);
    return v >> (64 - bits);
}

TEST(quotients)
{
    for (struct cases c = cases_of(300000); cases_next(&c);) {
        struct random *r = &c.random;
        const uint64_t d = random_long(r, random_between(r, 1, 62)) | 1;
        const uint64_t n = random_long(r, random_between(r, 1, 63));
        const int64_t q = (int64_t)(n / d), m = (int64_t)(n % d);
        const int64_t by = (int64_t)d;
        int64_t rest = (int64_t)n, below = ~rest;
        if (pel_divide_64(&rest, by) != q || rest != m ||
            pel_divide_64(&below, by) != ~q || below != by - 1 - m)
            fail_msg("%llu / %llu", (unsigned long long)n,
                     (unsigned long long)d);
        if (d >> 32 == 0 && n >> 32 < d &&
            pel_divide(n, (uint32_t)d) != (uint32_t)(n / d))
            fail_msg("%llu / %llu, 32 bits", (unsigned long long)n,
                     (unsigned long long)d);
    }
    assert_int_equal(pel_divide(UINT64_C(0xFFFFFFFEFFFFFFFF), UINT32_MAX),
                     UINT32_MAX);
}
