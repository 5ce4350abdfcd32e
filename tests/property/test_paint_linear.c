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
        cmocka_unit_test(test_exact_on_the_grid),
        cmocka_unit_test(test_errors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
