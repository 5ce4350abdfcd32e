/* The 32.32 walk of 64-bit CPUs: rows taken through a paint's `fast` function
 * against 128-bit arithmetic, at the borders of its two bounds (128 rows and
 * 16,384 px wide for one division, 4,094 px high for two). */
#include <stdlib.h>

#include "tests/support/check.h"
#include "tests/support/fast_rows.h"
#include "tests/support/reference.h"
#include "tests/support/shapes.h"

#if PEL_FAST_64BIT

struct probe {
    struct pel_paint paint;
    struct pel_point v[3]; /* top to bottom */
    uint64_t fast, slow, rows;
};

static void check_row(void *probe, int32_t y, int32_t x0, int32_t x1)
{
    struct probe *p = probe;
    const struct pel_point *v = p->v;
    const bool upper = (int64_t)y * 256 + 128 < v[1].y;
    int32_t a = reference_edge_at(&v[0], &v[2], y);
    int32_t b = reference_edge_at(&v[upper ? 0 : 1], &v[upper ? 1 : 2], y);
    p->rows++;
    if (x0 >= x1 && a == b)
        return;
    if (x0 != pel_min(a, b) || x1 != pel_max(a, b))
        fail_msg("row %d: expected %d..%d, got %d..%d; %s", y, pel_min(a, b),
                 pel_max(a, b), x0, x1, cases_replay());
}

static bool take_fast(const struct pel_paint *paint,
                      const struct pel_surface *surface,
                      const struct pel_fast_triangle *t)
{
    struct probe *p = (struct probe *)(uintptr_t)paint;
    (void)surface;
    fast_rows(t, check_row, p);
    p->fast++;
    return true;
}

static void take_rows(const struct pel_paint *paint,
                      const struct pel_rows *rows)
{
    struct probe *p = (struct probe *)(uintptr_t)paint;
    p->slow++;
    for (int i = 0; i < rows->n; i++)
        check_row(p, rows->y + i * rows->step, rows->row[i].x0,
                  rows->row[i].x1);
}

static int by_height(const void *a, const void *b)
{
    const struct pel_point *p = a, *q = b;
    return p->y != q->y ? (p->y > q->y) - (p->y < q->y)
                        : (p->x > q->x) - (p->x < q->x);
}

/* The surface shows everything but is never written: the paint only looks. */
static void check_triangle(struct probe *p, const struct pel_point v[3])
{
    static uint8_t nothing;
    const struct pel_rect bounds = {-16384, -16384, 16383, 16383};
    struct pel_surface s;
    assert_int_equal(
        pel_surface_init_rect(&s, &pel_gray8, &nothing, 32767, &bounds),
        PEL_OK);
    for (int i = 0; i < 3; i++)
        p->v[i] = v[i];
    qsort(p->v, 3, sizeof p->v[0], by_height);
    pel_triangle(&s, v, &p->paint);
}

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
    struct probe p = {{take_rows, take_fast}, {{0, 0}}, 0, 0, 0};
    for (struct cases c = cases_of(count); cases_next(&c);) {
        struct pel_point v[3];
        int32_t height =
            random_between(&c.random, PEL_PX(px[0]) - 2, PEL_PX(px[1]) + 2);
        int32_t w = random_between(&c.random, 0, 3)
                        ? random_between(&c.random, 0, width)
                        : width - random_between(&c.random, 0, 2);
        triangle_of_size(&c.random, w, height, v);
        check_triangle(&p, v);
    }
    print_message("%llu fast, %llu batches, %llu rows\n",
                  (unsigned long long)p.fast, (unsigned long long)p.slow,
                  (unsigned long long)p.rows);
    assert_true(p.fast > 0);
}

static void test_around_128_rows(void **state)
{
    (void)state;
    check_sizes(40000, (const int32_t[]){127, 129}, PEL_PX(400));
}

static void test_around_16384_px(void **state)
{
    (void)state;
    check_sizes(40000, (const int32_t[]){0, 129}, 4194304 + 2);
    check_sizes(40000, (const int32_t[]){128, 128}, 4194304 + 2);
}

static void test_around_4094_px(void **state)
{
    (void)state;
    check_sizes(800, (const int32_t[]){4093, 4096}, PEL_PX(5000));
    check_sizes(800, (const int32_t[]){4094, 4094}, PEL_PX(32000));
}

static void test_any_size(void **state)
{
    (void)state;
    check_sizes(4000, (const int32_t[]){1, 4094}, PEL_PX(32000));
    check_sizes(100000, (const int32_t[]){1, 40}, PEL_PX(40));
}

/* Slivers whose edges cross each row within a sub-pixel of each other, and
 * slopes next to whole numbers, where a drift would show first. */
static void test_tight_slopes(void **state)
{
    struct probe p = {{take_rows, take_fast}, {{0, 0}}, 0, 0, 0};
    (void)state;
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
        check_triangle(&p, v);
    }
    assert_true(p.fast > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_around_128_rows),
        cmocka_unit_test(test_around_16384_px),
        cmocka_unit_test(test_around_4094_px),
        cmocka_unit_test(test_any_size),
        cmocka_unit_test(test_tight_slopes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

#else

int main(void)
{
    return 0; /* built only where the walk exists */
}

#endif
