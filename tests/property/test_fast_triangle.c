/* The 32.32 walk of 64-bit CPUs against 128-bit arithmetic, at the borders of
 * its two bounds (128 rows for one division, 4,094 px high for two). */
#include "tests/support/check.h"
#include "tests/support/cases.h"
#include "tests/support/probe.h"

/* Three vertices in a box of that size, one at its top and one at its bottom,
 * one at its left and one at its right side. */
static void triangle_of_size(struct random *r, int32_t width, int32_t height,
                             struct pel_point v[3])
{
    const int32_t x = random_between(r, -4194304, 4194047 - width);
    const int32_t y = random_between(r, -4194304, 4194047 - height);
    const int32_t dx[3] = {0, width, random_between(r, 0, width)};
    const int32_t dy[3] = {0, height, random_between(r, 0, height)};
    const uint32_t i = random_word(r) % 3, j = random_word(r) % 3;
    for (uint32_t k = 0; k < 3; k++) {
        v[k].x = x + dx[(k + i) % 3];
        v[k].y = y + dy[(2 * k + j) % 3];
    }
    if (random_word(r) % 4 == 0)
        v[1].x = v[0].x + random_between(r, -1, 1) * (v[0].x < 4194047 - 1);
}

static void check_sizes(uint64_t count, const int32_t px[2], int32_t width)
{
    struct probe p;
    probe_open(&p);
    for (struct cases c = cases_of(count); cases_next(&c);) {
        struct pel_point v[3];
        int32_t height =
            random_between(&c.random, PEL_PX(px[0]) - 2, PEL_PX(px[1]) + 2);
        int32_t w = random_between(&c.random, 0, 3)
                        ? random_between(&c.random, 0, width)
                        : width - random_between(&c.random, 0, 2);
        triangle_of_size(&c.random, w, height, v);
        probe_triangle(&p, v);
    }
    print_message("%llu fast, %llu rows\n", (unsigned long long)p.fast,
                  (unsigned long long)p.rows);
    assert_true(p.fast > 0);
}

static void test_around_128_rows(void)
{
    check_sizes(40000, (const int32_t[]){127, 129}, PEL_PX(400));
}

static void test_as_wide_as_a_surface(void)
{
    const int32_t width = PEL_PX(32767) - 1;
    check_sizes(40000, (const int32_t[]){0, 129}, width);
    check_sizes(40000, (const int32_t[]){1, 1}, width);
    check_sizes(40000, (const int32_t[]){128, 128}, width);
}

static void test_around_4094_px(void)
{
    check_sizes(800, (const int32_t[]){4093, 4096}, PEL_PX(5000));
    check_sizes(800, (const int32_t[]){4094, 4094}, PEL_PX(32000));
}

static void test_any_size(void)
{
    check_sizes(4000, (const int32_t[]){1, 4094}, PEL_PX(32000));
    check_sizes(100000, (const int32_t[]){1, 40}, PEL_PX(40));
}

/* Slivers whose edges cross each row within a sub-pixel of each other, and
 * slopes next to whole numbers, where a drift would show first. */
static void test_tight_slopes(void)
{
    struct probe p;
    probe_open(&p);
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        int32_t dy =
            random_between(&c.random, 0, 3)
                ? random_between(&c.random, 32640, 32768)
                : random_between(&c.random, PEL_PX(4090), PEL_PX(4094));
        int32_t k = random_between(&c.random, -3, 3);
        int32_t x = random_between(&c.random, -4096, 4096);
        int32_t y = random_between(&c.random, -4096, 4096);
        int32_t dx = k * dy + random_between(&c.random, -2, 2);
        const struct pel_point v[3] = {
            {x, y}, {x + dx, y + dy}, {x + dx + 1, y + dy}};
        probe_triangle(&p, v);
    }
    assert_true(p.fast > 0);
}

int main(void)
{
    return RUN_TESTS(test_around_128_rows, test_as_wide_as_a_surface,
                     test_around_4094_px, test_any_size, test_tight_slopes);
}
