/* Where the corners of thick lines are, and broken contracts of shapes. */
#include "core/raster/thick_line.h"
#include "tests/support/any_shape.h"
#include "tests/support/check.h"
#include "tests/support/hits.h"

/* Newton's root, from above. */
static long double root(long double n)
{
    long double r = n > 1 ? n : 1;
    for (int i = 0; i < 200; i++)
        r = (r + n / r) / 2;
    return r;
}

static void check_near(int32_t got, long double want)
{
    if (got - want > 0.501L || want - got > 0.501L)
        fail_msg("corner: expected %Lf, got %d; %s", want, got, cases_replay());
}

static void test_corners_are_the_nearest(void)
{
    uint64_t checked = 0;
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        struct any_shape s;
        struct pel_point v[4], w[4];
        any_random(&c.random, &s, ANY_THICK_LINE, c.next % 2);
        const struct pel_point a = s.v[0], b = s.v[1];
        const struct pel_thick_line_shape line = {a, b, s.radius};
        const struct pel_thick_line_shape back = {b, a, s.radius};
        const long double dx = b.x - a.x, dy = b.y - a.y;
        const long double length = root(dx * dx + dy * dy);
        assert_int_equal(pel_thick_line_corners(&line, v),
                         pel_thick_line_corners(&back, w));
        if (length < 0.5L || !pel_thick_line_corners(&line, v))
            continue;
        check_near(v[0].x, a.x - dy * s.radius / (2 * length));
        check_near(v[0].y, a.y + dx * s.radius / (2 * length));
        check_near(v[2].x, b.x + dy * s.radius / (2 * length));
        check_near(v[2].y, b.y - dx * s.radius / (2 * length));
        assert_true(v[0].x == w[2].x && v[0].y == w[2].y && v[1].x == w[3].x &&
                    v[1].y == w[3].y && v[2].x == w[0].x && v[2].y == w[0].y);
        checked++;
    }
    assert_true(checked > 0);
}

static void test_corners_of_a_point(void)
{
    struct pel_point v[4];
    const struct pel_thick_line_shape line = {PEL_AT(3, 4), PEL_AT(3, 4), 512};
    assert_true(pel_thick_line_corners(&line, v));
    for (int i = 0; i < 4; i++)
        assert_true(v[i].x == PEL_PX(3) && v[i].y == PEL_PX(4));
}

static struct hits hits;

static void check_nothing(const struct any_shape *s)
{
    const struct pel_rect window = {-20, -20, 20, 20};
    hits_open(&hits, &window);
    any_draw(&hits.surface, s, &hits.paint);
    any_draw_outline(&hits.surface, s, &hits.paint);
    assert_int_equal(hits.pixels, 0);
    assert_false(any_hit(s, 0, 0));
}

/* Nothing is drawn and nothing is hit beyond the range. The shapes hold pixel
 * (0, 0) but for what is out of range. */
static void test_out_of_range(void)
{
    static const enum any_kind kinds[] = {ANY_ELLIPSE, ANY_ROUNDED_RECTANGLE,
                                          ANY_RING,    ANY_SECTOR,
                                          ANY_ARC,     ANY_THICK_LINE};
    static const int32_t radii[] = {-1, INT32_MIN, PEL_PX(32767) + 1,
                                    INT32_MAX};
    const struct any_shape good = {.v = {{-900, -900}, {900, 900}},
                                   .radius = 2000,
                                   .inner = 1400,
                                   .from = 100,
                                   .to = 40000};
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        struct any_shape s = good;
        s.kind = kinds[i];
        assert_true(any_hit(&s, 0, 0));
        for (size_t k = 0; k < 4; k++) {
            s.radius = radii[k];
            check_nothing(&s);
        }
        s = good;
        s.kind = kinds[i];
        s.radius = PEL_PX(32767); /* reaches the window from there */
        s.from = 0;
        s.v[0].x = PEL_COORDINATE_MIN - 1;
        check_nothing(&s);
        s.from = 40000;
        s.to = 60000;
        s.v[0] = good.v[0];
        s.v[0].y = PEL_COORDINATE_MAX + 1;
        check_nothing(&s);
    }
}

int main(void)
{
    return RUN_TESTS(test_corners_are_the_nearest, test_corners_of_a_point,
                     test_out_of_range);
}
