/* The 32.32 walk of 64-bit CPUs against 128-bit arithmetic, at the borders of
 * its two bounds (128 rows for one division, 4,094 px high for two); and when a
 * paint's `fast` is asked. */
#include "tests/support/cases.h"
#include "tests/support/check.h"
#include "tests/support/shapes.h"
#include "tests/support/layouts.h"
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
        shape_keep(v, 3);
        probe_triangle(&p, v);
    }
    print_message("%llu fast, %llu rows\n", (unsigned long long)p.fast,
                  (unsigned long long)p.rows);
    assert_true(cases_alone() || p.fast > 0);
}

TEST(around_128_rows)
{
    check_sizes(40000, (const int32_t[]){127, 129}, PEL_PX(400));
}

TEST(as_wide_as_a_surface)
{
    const int32_t width = PEL_PX(32767) - 1;
    check_sizes(40000, (const int32_t[]){0, 129}, width);
    check_sizes(40000, (const int32_t[]){1, 1}, width);
    check_sizes(40000, (const int32_t[]){128, 128}, width);
}

TEST(around_4094_px)
{
    check_sizes(800, (const int32_t[]){4093, 4096}, PEL_PX(5000));
    check_sizes(800, (const int32_t[]){4094, 4094}, PEL_PX(32000));
}

TEST(any_size)
{
    check_sizes(4000, (const int32_t[]){1, 4094}, PEL_PX(32000));
    check_sizes(100000, (const int32_t[]){1, 40}, PEL_PX(40));
}

/* Slivers whose edges cross each row within a sub-pixel of each other, and
 * slopes next to whole numbers, where a drift would show first. */
TEST(tight_slopes)
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
        shape_keep(v, 3);
        probe_triangle(&p, v);
    }
    assert_true(cases_alone() || p.fast > 0);
}

struct counting {
    struct pel_paint paint;
    bool takes;
    int fast, rows;
};

static void count_rows(const struct pel_paint *paint,
                       const struct pel_spans *rows)
{
    ((struct counting *)(uintptr_t)paint)->rows += rows->n;
}

static bool count_fast(const struct pel_paint *paint,
                       const struct pel_surface *surface,
                       const struct pel_fast_triangle *triangle)
{
    struct counting *c = (struct counting *)(uintptr_t)paint;
    (void)surface;
    (void)triangle;
    c->fast++;
    return c->takes;
}

/* `fast` is asked once, where nothing is clipped; what it leaves comes as rows.
 */
TEST(fast_is_asked_first)
{
    static const struct pel_point inside[3] = {PEL_AT(0, 0), PEL_AT(8, 0),
                                               PEL_AT(0, 8)};
    static const struct pel_point clipped[3] = {
        PEL_AT(0, 0), {2049, 0}, PEL_AT(0, 8)};
    static const struct pel_point empty[3] = {
        {129, 129}, {300, 129}, {200, 380}};
    static const struct {
        const struct pel_point *v;
        bool takes;
        int fast, rows;
    } row[] = {{inside, true, 1, 0},
               {inside, false, 1, 8},
               {clipped, true, 0, 8},
               {empty, true, 0, 0}};
    static uint8_t pixels[64];
    struct pel_surface s;
    s = surface_of(&pel_gray8, pixels, sizeof pixels, 8, 8);
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct counting c = {{count_rows, count_fast}, row[i].takes, 0, 0};
        pel_triangle(&s, row[i].v, &c.paint);
        if (c.fast != row[i].fast || c.rows != row[i].rows)
            fail_msg("row %zu: %d times fast, %d rows", i, c.fast, c.rows);
    }
}
