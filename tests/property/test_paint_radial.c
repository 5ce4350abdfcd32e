/* Radial gradients against exact roots: the bounds of paint_radial.h. */
#include "core/paint/paint_radial.h"
#include "tests/support/check.h"
#include "tests/support/paint_cells.h"
#include "tests/support/shapes.h"

static struct histogram errors = {.name = "radial_position_px",
                                  .step = 0x1p-14L};

static int32_t random_size(struct random *r, int bits)
{
    int32_t reach = (1 << random_between(r, 0, bits)) - 1;
    return random_between(r, -reach, reach);
}

/* Centres anywhere; on pixel centres and edges, and a sub-pixel beside. */
static struct pel_rings random_rings(struct random *r)
{
    struct pel_rings g;
    struct pel_point v[3];
    shape_adversarial(r, v, 3);
    g.center.x = random_word(r) % 2 ? v[0].x : random_size(r, 23);
    g.center.y = random_word(r) % 2 ? v[0].y : random_size(r, 23);
    g.radius = pel_max(256, random_size(r, 23) & 0x7FFFFF);
    g.radius = pel_min(g.radius, PEL_PX(32767));
    if (random_word(r) % 4 == 0)
        g.radius = PEL_PX(random_between(r, 1, 20));
    g.phase = (uint16_t)(random_word(r) % 2 ? random_word(r) : 0);
    return g;
}

static int32_t random_pixel(struct random *r, int32_t center)
{
    int32_t i = pel_pixel_of(center) + random_size(r, 16);
    return pel_max(-32768, pel_min(32767 - 128, i));
}

static real distance_of(const struct pel_rings *g, int32_t x, int32_t y)
{
    real dx = (real)pel_pixel_center(x) - g->center.x;
    real dy = (real)pel_pixel_center(y) - g->center.y;
    return real_root(dx * dx + dy * dy);
}

/* Less than 1 sub-pixel off, and less than 2^-11 of the way. */
static void check_pixel(const struct pel_rings *g, const struct pel_ramp *ramp,
                        int32_t x, int32_t y, pel_color got)
{
    real t = distance_of(g, x, y) / g->radius + g->phase / 65536.0L;
    real bound = 1.0L / g->radius;
    if (bound > 0x1p-11L)
        bound = 0x1p-11L;
    real off = cells_distance(ramp, got, t, bound);
    if (off > bound)
        fail_msg("centre %d,%d radius %d phase %u, pixel %d, %d, n %d, spread "
                 "%d: t %Lg, got %08x, %Lg of the way off; %s",
                 g->center.x, g->center.y, g->radius, g->phase, x, y, ramp->n,
                 (int)ramp->spread, t, got, off, cases_replay());
    histogram_add(&errors, off * g->radius / 256);
}

static void test_positions(void **state)
{
    (void)state;
    for (struct cases c = cases_of(60000); cases_next(&c);) {
        struct random *r = &c.random;
        const struct pel_rings g = random_rings(r);
        const struct pel_ramp ramp = cells_random(r);
        const int32_t y = random_pixel(r, g.center.y);
        const int32_t x = random_pixel(r, g.center.x);
        const int32_t n = random_between(r, 1, 128);
        struct pel_radial p;
        pel_color got[128], one;
        assert_int_equal(pel_radial_init(&p, &g, &ramp), PEL_OK);
        p.base.colors(&p.base, x, y, n, got);
        for (int32_t i = 0; i < n; i++)
            check_pixel(&g, &ramp, x + i, y, got[i]);
        const int32_t k = random_between(r, 0, n - 1);
        p.base.colors(&p.base, x + k, y, 1, &one);
        assert_int_equal(one, got[k]);
    }
    histogram_end(&errors);
}

/* Near the centre there is one root for every pixel: rings of whole pixels
 * around a pixel's centre begin where they must. */
static void test_exact_rings(void **state)
{
    (void)state;
    const struct pel_rings g = {
        {PEL_PX(5) + 128, PEL_PX(9) + 128}, PEL_PX(100), 0};
    const struct pel_ramp ramp = cells_ramp(100, PEL_REPEAT);
    struct pel_radial p;
    pel_color got[101];
    assert_int_equal(pel_radial_init(&p, &g, &ramp), PEL_OK);
    p.base.colors(&p.base, 5, 9, 101, got);
    for (int32_t i = 0; i <= 8; i++)
        assert_int_equal(got[i], 0xFF000000u + (uint32_t)(i % 100));
    p.base.colors(&p.base, 5 + 3, 9 + 4, 1, got);
    assert_int_equal(got[0], 0xFF000005u);
}

static void test_errors(void **state)
{
    (void)state;
    struct pel_rings g = {PEL_AT(3, 4), 256, 0};
    struct pel_ramp ramp = cells_ramp(5, PEL_PAD);
    struct pel_radial p;
    assert_int_equal(pel_radial_init(&p, &g, &ramp), PEL_OK);
    assert_int_equal(pel_radial_init(NULL, &g, &ramp), PEL_ERROR_NULL);
    assert_int_equal(pel_radial_init(&p, NULL, &ramp), PEL_ERROR_NULL);
    assert_int_equal(pel_radial_init(&p, &g, NULL), PEL_ERROR_NULL);
    g.radius = 255;
    assert_int_equal(pel_radial_init(&p, &g, &ramp), PEL_ERROR_RANGE);
    g.radius = PEL_PX(32767) + 1;
    assert_int_equal(pel_radial_init(&p, &g, &ramp), PEL_ERROR_RANGE);
    g.radius = 256;
    g.center.x = PEL_COORDINATE_MIN - 1;
    assert_int_equal(pel_radial_init(&p, &g, &ramp), PEL_ERROR_RANGE);
    g.center.x = 0;
    ramp.n = 0;
    assert_int_equal(pel_radial_init(&p, &g, &ramp), PEL_ERROR_SIZE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_positions),
        cmocka_unit_test(test_exact_rings),
        cmocka_unit_test(test_errors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
