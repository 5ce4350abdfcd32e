/* The numbers under the paints: square roots, angles, quotients. */
#include "core/base/fraction.h"
#include "core/base/root.h"
#include "core/base/turn.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"
#include "tests/support/paint_math.h"

__extension__ typedef __int128 wide;

static void check_root(uint64_t v)
{
    struct pel_root r;
    pel_square_root(v, &r);
    const struct pel_root whole = pel_root_of(v);
    if (whole.root != r.root || whole.inverse != r.inverse ||
        whole.shift != r.shift)
        fail_msg("roots of %llu: %u and %u", (unsigned long long)v, r.root,
                 whole.root);
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
static void test_roots(void **state)
{
    (void)state;
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

static int32_t random_way(struct random *r)
{
    int32_t reach = (1 << random_between(r, 0, 25)) - 1;
    return random_between(r, -reach, reach);
}

static void test_angles(void **state)
{
    (void)state;
    struct histogram h = {.name = "turn_of", .step = 0x1p-36L};
    for (struct cases c = cases_of(1000000); cases_next(&c);) {
        int32_t x = random_way(&c.random), y = random_way(&c.random);
        real error =
            pel_turn_of(x, y) / 4294967296.0L - real_turn((real)x, (real)y);
        error -= real_round(error);
        histogram_add(&h, error);
        if (real_abs(error) >= 0x1p-30L)
            fail_msg("angle of %d, %d is off by %Lg turns", x, y, error);
    }
    histogram_end(&h);
}

static void test_axes_and_diagonals_are_exact(void **state)
{
    (void)state;
    static const int8_t way[8][2] = {{1, 0},  {1, 1},   {0, 1},  {-1, 1},
                                     {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
    assert_int_equal(pel_turn_of(0, 0), 0);
    for (int32_t size = 1; size < 1 << 25; size += size / 3 + 1)
        for (uint32_t i = 0; i < 8; i++)
            assert_int_equal(pel_turn_of(way[i][0] * size, way[i][1] * size),
                             i << 29);
}

static int64_t random_long(struct random *r, int bits)
{
    uint64_t v = (uint64_t)random_word(r) << 32 | random_word(r);
    return (int64_t)(v >> (64 - bits));
}

static void test_quotients(void **state)
{
    (void)state;
    for (struct cases c = cases_of(300000); cases_next(&c);) {
        struct random *r = &c.random;
        int64_t d = random_long(r, random_between(r, 1, 51));
        int64_t n = random_long(r, random_between(r, 1, 63));
        int bits = random_between(r, 0, 40);
        if (d == 0)
            continue;
        if (random_word(r) % 2)
            n = -n;
        wide scaled = (wide)n * ((wide)1 << bits), q = scaled / d;
        q -= scaled % d < 0;
        if (pel_fraction_of(n, d, bits) != (uint64_t)q)
            fail_msg("%lld / %lld with %d bits", (long long)n, (long long)d,
                     bits);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_roots),
        cmocka_unit_test(test_angles),
        cmocka_unit_test(test_axes_and_diagonals_are_exact),
        cmocka_unit_test(test_quotients),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
