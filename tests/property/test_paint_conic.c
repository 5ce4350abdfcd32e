/* Conic gradients against exact angles: the bounds of paint_conic.h. */
#include "core/base/hsv.h"
#include "core/paint/paint_hue.h"
#include "tests/support/check.h"
#include "tests/support/paint_cells.h"
#include "tests/support/shapes.h"

static struct histogram turns = {.name = "conic_error_turns",
                                 .step = 1e-7L * 2},
                        pixels = {.name = "conic_error_px", .step = 0x1p-14L};

/* A conic paint that keeps positions and has no colours. */
struct probe {
    struct pel_conic conic;
    uint64_t *next;
};

static void keep_some(const struct pel_curve *curve, struct pel_ramp_walk *walk,
                      int32_t n)
{
    const struct pel_conic *conic = PEL_CURVE_PAINT(struct pel_conic, curve);
    uint64_t **next = &((struct probe *)(uintptr_t)conic)->next;
    for (; n > 0; n--, pel_ramp_step(walk))
        *(*next)++ = walk->at;
}

#if PEL_FAST_64BIT

static void keep(const void *curve, const struct pel_ramp_walk *walk,
                 pel_color *colors)
{
    struct pel_ramp_walk w = *walk;
    (void)colors;
    keep_some(curve, &w, w.n);
}

#else

static void keep(const struct pel_curve *curve, struct pel_ramp_walk *walk,
                 int32_t n, pel_color *colors)
{
    (void)colors;
    keep_some(curve, walk, n);
}

#endif

static int32_t random_size(struct random *r, int bits)
{
    int32_t reach = (1 << random_between(r, 0, bits)) - 1;
    return random_between(r, -reach, reach);
}

static struct pel_point random_center(struct random *r)
{
    struct pel_point v[3];
    shape_adversarial(r, v, 3);
    if (random_word(r) % 2)
        return (struct pel_point){random_size(r, 23), random_size(r, 23)};
    return v[0];
}

static int32_t random_pixel(struct random *r, int32_t center)
{
    int32_t i = pel_pixel_of(center) + random_size(r, 16);
    return pel_max(-32768, pel_min(32767 - 128, i));
}

static void check_angle(const struct probe *p, int32_t x, int32_t y,
                        uint64_t at)
{
    real dx = (real)pel_pixel_center(x) - p->conic.curve.center.x;
    real dy = (real)pel_pixel_center(y) - p->conic.curve.center.y;
    real r = real_root(dx * dx + dy * dy) / 256;
    real error = (real)at / 18446744073709551616.0L - real_turn(dx, dy) +
                 (real)p->conic.start / 4294967296.0L;
    error = real_abs(error - real_round(error));
    real shift = error * r * 6.283185307179586L;
    if (error >= 1e-5L || shift >= 1.0L / 256)
        fail_msg("centre %d,%d, pixel %d,%d: %Lg turns, %Lg px off; %s",
                 p->conic.curve.center.x, p->conic.curve.center.y, x, y, error,
                 shift, cases_replay());
    histogram_add(&turns, error);
    histogram_add(&pixels, shift);
}

static void test_angles(void **state)
{
    (void)state;
    for (struct cases c = cases_of(60000); cases_next(&c);) {
        struct random *r = &c.random;
        const struct pel_point center = random_center(r);
        const int32_t y = random_pixel(r, center.y);
        const int32_t x = random_pixel(r, center.x);
        const int32_t n = random_between(r, 1, 128);
        uint64_t at[128];
        pel_color none[128];
        struct probe p;
        assert_int_equal(
            pel_conic_begin(&p.conic, center, (uint16_t)random_word(r), keep),
            PEL_OK);
        p.next = at;
        p.conic.base.colors(&p.conic.base, x, y, n, none);
        for (int32_t i = 0; i < n; i++)
            check_angle(&p, x + i, y, at[i]);
    }
    histogram_end(&turns);
    histogram_end(&pixels);
}

/* The colour of the cell where the angle is; there and back when reflected. */
static void test_colors(void **state)
{
    (void)state;
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        struct random *r = &c.random;
        const struct pel_point center = random_center(r);
        struct pel_ramp ramp = cells_random(r);
        struct pel_conic p;
        const uint16_t start = (uint16_t)random_word(r);
        const int32_t x = random_pixel(r, center.x), n = 64;
        const int32_t y = random_pixel(r, center.y);
        pel_color got[64], one;
        assert_int_equal(pel_conic_init(&p, center, start, &ramp), PEL_OK);
        p.base.colors(&p.base, x, y, n, got);
        if (ramp.spread == PEL_PAD)
            ramp.spread = PEL_REPEAT;
        for (int32_t i = 0; i < n; i++) {
            real turn = real_turn((real)pel_pixel_center(x + i) - center.x,
                                  (real)pel_pixel_center(y) - center.y) -
                        start / 65536.0L;
            real way = ramp.spread == PEL_REFLECT ? 2 : 1;
            if (cells_distance(&ramp, got[i], turn * way, way * 1e-5L) >
                way * 1e-5L)
                fail_msg("centre %d,%d, pixel %d,%d, n %d: got %08x; %s",
                         center.x, center.y, x + i, y, ramp.n, got[i],
                         cases_replay());
        }
        p.base.colors(&p.base, x + 33, y, 1, &one);
        assert_int_equal(one, got[33]);
    }
}

/* Near the centre every pixel has an angle of its own: quarter and eighth turns
 * fall on the beginning of a cell. */
static void test_axes_are_exact(void **state)
{
    (void)state;
    static const int8_t way[8][2] = {{1, 0},  {1, 1},   {0, 1},  {-1, 1},
                                     {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
    const struct pel_ramp ramp = cells_ramp(8, PEL_REPEAT);
    const struct pel_point center = {PEL_PX(40) + 128, PEL_PX(30) + 128};
    struct pel_conic p;
    assert_int_equal(pel_conic_init(&p, center, 0, &ramp), PEL_OK);
    for (uint32_t i = 0; i < 8; i++)
        for (int32_t k = 1; k < 11; k++) {
            pel_color got;
            p.base.colors(&p.base, 40 + way[i][0] * k, 30 + way[i][1] * k, 1,
                          &got);
            assert_int_equal(got, 0xFF000000u + i);
        }
}

static void test_hue_wheel(void **state)
{
    (void)state;
    const struct pel_point center = {PEL_PX(300) + 77, PEL_PX(200) - 3};
    struct pel_hue_wheel p;
    struct pel_color_paint *base = &p.conic.base;
    pel_color got[600];
    assert_int_equal(pel_hue_wheel_init(&p, center, 1000, 200, 250), PEL_OK);
    assert_true(base->opaque);
    for (int32_t y = 0; y < 400; y += 3) {
        base->colors(base, 0, y, 600, got);
        for (int32_t x = 0; x < 600; x++) {
            real turn = real_turn((real)pel_pixel_center(x) - center.x,
                                  (real)pel_pixel_center(y) - center.y);
            int32_t low = (int32_t)real_floor(65536 * (turn - 1e-5L)) - 1000;
            int32_t high = (int32_t)real_floor(65536 * (turn + 1e-5L)) - 1000;
            if (got[x] != pel_hsv(low, 200, 250) &&
                got[x] != pel_hsv(high, 200, 250))
                fail_msg("pixel %d,%d: hue %d, got %08x", x, y, low, got[x]);
        }
    }
}

/* The lowest channel is the same for every hue. */
static void test_every_saturation_and_value(void **state)
{
    (void)state;
    const struct pel_point center = PEL_AT(3, 4);
    for (int s = 0; s < 256; s++)
        for (int v = 0; v < 256; v++) {
            const pel_color want = pel_hsv(0, (uint8_t)s, (uint8_t)v);
            struct pel_hue_wheel p;
            pel_color got;
            pel_hue_wheel_init(&p, center, 0, (uint8_t)s, (uint8_t)v);
            p.conic.base.colors(&p.conic.base, s, v, 1, &got);
            const int32_t low =
                pel_min((int32_t)pel_red(got), pel_min((int32_t)pel_green(got),
                                                       (int32_t)pel_blue(got)));
            if (low != (int32_t)pel_blue(want))
                fail_msg("s %d, v %d: %08x, expected %08x", s, v, got, want);
        }
}

static void test_errors(void **state)
{
    (void)state;
    struct pel_point center = PEL_AT(3, 4);
    struct pel_ramp ramp = cells_ramp(5, PEL_PAD);
    struct pel_conic p;
    struct pel_hue_wheel w;
    assert_int_equal(pel_conic_init(NULL, center, 0, &ramp), PEL_ERROR_NULL);
    assert_int_equal(pel_conic_init(&p, center, 0, NULL), PEL_ERROR_NULL);
    assert_int_equal(pel_hue_wheel_init(NULL, center, 0, 1, 1), PEL_ERROR_NULL);
    center.y = PEL_COORDINATE_MAX + 1;
    assert_int_equal(pel_conic_init(&p, center, 0, &ramp), PEL_ERROR_RANGE);
    assert_int_equal(pel_hue_wheel_init(&w, center, 0, 1, 1), PEL_ERROR_RANGE);
    ramp.n = 0;
    assert_int_equal(pel_conic_init(&p, center, 0, &ramp), PEL_ERROR_SIZE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_angles),
        cmocka_unit_test(test_colors),
        cmocka_unit_test(test_axes_are_exact),
        cmocka_unit_test(test_hue_wheel),
        cmocka_unit_test(test_every_saturation_and_value),
        cmocka_unit_test(test_errors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
