/* Where the corners of thick lines are. */
#include "core/raster/thick_line.h"
#include "tests/support/any_shape.h"
#include "tests/support/check.h"
#include "tests/support/paint_math.h"

static void check_near(int32_t got, real want)
{
    if (got - want > 0.501L || want - got > 0.501L)
        fail_msg("corner: expected %Lf, got %d; %s", want, got, cases_replay());
}

TEST(corners_are_the_nearest)
{
    uint64_t checked = 0;
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        struct any_shape s;
        struct pel_point v[4], w[4];
        any_random(&c.random, &s, ANY_THICK_LINE, c.next % 2);
        const struct pel_point a = s.v[0], b = s.v[1];
        const struct pel_thick_line_shape line = {a, b, s.radius};
        const struct pel_thick_line_shape back = {b, a, s.radius};
        const real dx = b.x - a.x, dy = b.y - a.y;
        const real length = real_root(dx * dx + dy * dy);
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

TEST(corners_of_a_point)
{
    struct pel_point v[4];
    const struct pel_thick_line_shape line = {PEL_AT(3, 4), PEL_AT(3, 4), 512};
    assert_true(pel_thick_line_corners(&line, v));
    for (int i = 0; i < 4; i++)
        assert_true(v[i].x == PEL_PX(3) && v[i].y == PEL_PX(4));
}
