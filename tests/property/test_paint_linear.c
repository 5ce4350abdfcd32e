/* Linear gradients against exact positions: the bound of paint_linear.h. */
#include "core/paint/paint_linear.h"
#include "tests/support/check.h"
#include "tests/support/paint_cells.h"
#include "tests/support/shapes.h"

static struct histogram errors = {.name = "linear_position_subpixels",
                                  .step = 0x1p-22L};

struct ends {
    struct pel_point from, to;
};

static struct ends random_ends(struct random *r)
{
    struct pel_point v[3];
    if (random_word(r) % 2)
        shape_random(r, v, 3);
    else
        shape_adversarial(r, v, 3);
    if (v[0].x == v[1].x && v[0].y == v[1].y)
        v[1].x += v[1].x < 0 ? 1 : -1;
    return (struct ends){v[0], v[1]};
}

/* t, and the sub-pixels of one unit of it. */
static real position(const struct ends *e, int32_t x, int32_t y, real *length)
{
    real dx = (real)e->to.x - e->from.x, dy = (real)e->to.y - e->from.y;
    real px = (real)pel_pixel_center(x) - e->from.x;
    real py = (real)pel_pixel_center(y) - e->from.y;
    *length = real_root(dx * dx + dy * dy);
    return (px * dx + py * dy) / (dx * dx + dy * dy);
}

/* Here long double is off by some 2^-60 of t. */
static void check_pixel(const struct ends *e, const struct pel_ramp *ramp,
                        int32_t x, int32_t y, pel_color got)
{
    real length, t = position(e, x, y, &length);
    real bound = 0x1p-16L / length + 0x1p-32L + real_abs(t) * 0x1p-60L;
    real distance = cells_distance(ramp, got, t, bound);
    if (distance > bound)
        fail_msg("from %d,%d to %d,%d, pixel %d, %d, n %d, spread %d: t %Lg, "
                 "got %08x, %Lg sub-pixels off; %s",
                 e->from.x, e->from.y, e->to.x, e->to.y, x, y, ramp->n,
                 (int)ramp->spread, t, got, distance * length, cases_replay());
    histogram_add(&errors, distance * length);
}

static void test_positions(void **state)
{
    (void)state;
    for (struct cases c = cases_of(100000); cases_next(&c);) {
        struct random *r = &c.random;
        const struct ends e = random_ends(r);
        const struct pel_point corners[2] = {e.from, e.to};
        const struct pel_rect w = shape_window(r, corners, 2, 24);
        const struct pel_ramp ramp = cells_random(r);
        const int32_t y = random_between(r, w.y0, w.y1 - 1), n = w.x1 - w.x0;
        struct pel_linear p;
        pel_color got[24];
        assert_int_equal(pel_linear_init(&p, e.from, e.to, &ramp), PEL_OK);
        p.base.colors(&p.base, w.x0, y, n, got);
        for (int32_t i = 0; i < n; i++)
            check_pixel(&e, &ramp, w.x0 + i, y, got[i]);
    }
    histogram_end(&errors);
}

/* Where the steps' errors are all there, and of one sign: from one corner of
 * the range to the other, along ways that are long for their bits. */
static void test_farthest_pixels(void **state)
{
    (void)state;
    for (struct cases c = cases_of(4000); cases_next(&c);) {
        struct random *r = &c.random;
        const int32_t longest = 4 << random_between(r, 0, 8);
        const struct pel_point from = {
            PEL_PX(32767) - random_between(r, 0, 999),
            PEL_PX(32767) - random_between(r, 0, 999)};
        const struct ends e = {
            from,
            {from.x - random_between(r, longest - longest / 8 - 1, longest - 1),
             from.y -
                 random_between(r, longest - longest / 8 - 1, longest - 1)}};
        const struct pel_ramp ramp = cells_ramp(CELLS_MAX, PEL_REPEAT);
        const int32_t x = random_between(r, -32768, -32700);
        const int32_t y = random_between(r, -32768, -32700);
        struct pel_linear p;
        pel_color got[24];
        assert_int_equal(pel_linear_init(&p, e.from, e.to, &ramp), PEL_OK);
        p.base.colors(&p.base, x, y, 24, got);
        for (int32_t i = 0; i < 24; i++)
            check_pixel(&e, &ramp, x + i, y, got[i]);
    }
}

/* As many bits of a fraction as the range leaves: 36, and one for each doubling
 * of the way's longer side. */
static void test_bits(void **state)
{
    (void)state;
    const struct pel_ramp ramp = cells_ramp(2, PEL_PAD);
    const struct pel_point from = {PEL_COORDINATE_MIN, PEL_COORDINATE_MAX};
    for (int e = 0; e < 24; e++) {
        const int32_t shortest = 1 << e, longest = 2 * shortest - 1;
        const struct pel_point to[3] = {{from.x + shortest, from.y},
                                        {from.x, from.y - longest},
                                        {from.x + shortest, from.y - shortest}};
        for (int i = 0; i < 3; i++) {
            struct pel_linear p;
            assert_int_equal(pel_linear_init(&p, from, to[i], &ramp), PEL_OK);
            assert_int_equal(p.bits, 36 + e);
        }
    }
}

/* What can be said without a bound: whole cells of one pixel each. */
static void test_exact_on_the_grid(void **state)
{
    (void)state;
    for (int32_t n = 3; n < 400; n++) {
        const struct pel_ramp ramp = cells_ramp(n, PEL_REPEAT);
        const struct pel_point from = {PEL_PX(17) + 128, 5};
        const struct pel_point to = {from.x + PEL_PX(n), 5};
        struct pel_linear p;
        pel_color got[800];
        assert_int_equal(pel_linear_init(&p, from, to, &ramp), PEL_OK);
        p.base.colors(&p.base, 17, 0, 800, got);
        for (int32_t i = 0; i < 800; i++)
            assert_int_equal(got[i], 0xFF000000u + (uint32_t)(i % n));
    }
}

/* One run and its pixels one by one, the last with the error of all steps. */
static void test_long_runs(void **state)
{
    (void)state;
    static pel_color got[65536];
    for (struct cases c = cases_of(20); cases_next(&c);) {
        struct random *r = &c.random;
        const struct pel_ramp ramp =
            cells_ramp(CELLS_MAX, (enum pel_spread)(c.next % 3));
        const struct pel_point from = {random_between(r, -900, 900),
                                       random_between(r, -900, 900)};
        const struct pel_point to = {from.x + random_between(r, 1, 9),
                                     from.y + random_between(r, -9, 9)};
        struct pel_linear p;
        assert_int_equal(pel_linear_init(&p, from, to, &ramp), PEL_OK);
        p.base.colors(&p.base, -32768, 3, 65536, got);
        for (int32_t i = 0; i < 65536; i += 1 + i % 256) {
            pel_color one;
            p.base.colors(&p.base, i - 32768, 3, 1, &one);
            assert_int_equal(got[i], one);
        }
    }
}

static void test_errors(void **state)
{
    (void)state;
    const struct pel_point a = PEL_AT(1, 2), b = PEL_AT(3, 4);
    const struct pel_point far = {PEL_COORDINATE_MAX + 1, 0};
    struct pel_ramp ramp = cells_ramp(5, PEL_PAD);
    struct pel_linear p;
    assert_int_equal(pel_linear_init(NULL, a, b, &ramp), PEL_ERROR_NULL);
    assert_int_equal(pel_linear_init(&p, a, b, NULL), PEL_ERROR_NULL);
    assert_int_equal(pel_linear_init(&p, a, a, &ramp), PEL_ERROR_SIZE);
    assert_int_equal(pel_linear_init(&p, far, b, &ramp), PEL_ERROR_RANGE);
    assert_int_equal(pel_linear_init(&p, a, far, &ramp), PEL_ERROR_RANGE);
    ramp.n = 0;
    assert_int_equal(pel_linear_init(&p, a, b, &ramp), PEL_ERROR_SIZE);
    ramp.n = 32768;
    assert_int_equal(pel_linear_init(&p, a, b, &ramp), PEL_ERROR_SIZE);
    ramp.colors = NULL;
    assert_int_equal(pel_linear_init(&p, a, b, &ramp), PEL_ERROR_NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_positions),
        cmocka_unit_test(test_farthest_pixels),
        cmocka_unit_test(test_bits),
        cmocka_unit_test(test_exact_on_the_grid),
        cmocka_unit_test(test_long_runs),
        cmocka_unit_test(test_errors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
