/* Hit tests: a list of targets, thick lines of a few sub-pixels. That each
 * equals its fill is tested with the fills (property/test_round_coverage);
 * numbers out of range: test_all_assert.c. */
#include "tests/support/any_shape.h"
#include "tests/support/check.h"
#include "tests/support/paint_math.h"

struct disc_target {
    struct pel_target target;
    struct pel_point center;
    int32_t radius;
};

static int asked;

static bool disc_hit(const struct pel_target *target, int32_t x, int32_t y)
{
    const struct disc_target *d = (const struct disc_target *)target;
    asked++;
    return pel_hit_circle(d->center, d->radius, x, y);
}

/* A target without a box. */
#define ALWAYS         \
    {                  \
        disc_hit,      \
        {              \
            0, 0, 0, 0 \
        }              \
    }

TEST(topmost)
{
    const struct disc_target big = {ALWAYS, PEL_AT(50, 50), PEL_PX(40)};
    const struct disc_target left = {ALWAYS, PEL_AT(40, 50), PEL_PX(12)};
    const struct disc_target right = {ALWAYS, PEL_AT(60, 50), PEL_PX(12)};
    const struct pel_target *const list[] = {&big.target, &left.target,
                                             &right.target};
    assert_int_equal(pel_hit_topmost(list, 3, 50, 50), 2);
    assert_int_equal(pel_hit_topmost(list, 3, 35, 50), 1);
    assert_int_equal(pel_hit_topmost(list, 3, 50, 20), 0);
    assert_int_equal(pel_hit_topmost(list, 3, 5, 5), -1);
    assert_int_equal(pel_hit_topmost(list, 0, 50, 50), -1);
    assert_int_equal(pel_hit_topmost(NULL, -1, 50, 50), -1);
    assert_int_equal(pel_hit_topmost(NULL, INT32_MIN, 50, 50), -1);
    asked = 0;
    pel_hit_topmost(list, 3, 65, 50);
    assert_int_equal(asked, 1);
}

/* A target with a box is asked inside of it, all others everywhere. */
TEST(boxes)
{
    static const struct pel_rect box[] = {
        {10, 20, 13, 22}, {10, 20, 10, 22}, {10, 20, 13, 20}, {13, 22, 10, 20}};
    for (int i = 0; i < 4; i++) {
        const struct disc_target t = {
            {disc_hit, box[i]}, PEL_AT(0, 0), PEL_PX(99)};
        const struct pel_target *const list[] = {&t.target};
        for (int32_t y = 17; y < 25; y++)
            for (int32_t x = 7; x < 16; x++) {
                const bool inside = x >= 10 && x < 13 && y >= 20 && y < 22;
                asked = 0;
                const int32_t top = pel_hit_topmost(list, 1, x, y);
                assert_int_equal(asked, i > 0 || inside);
                assert_int_equal(top, asked - 1);
            }
    }
}

/* Around one pixel's centre, where every sub-pixel of a corner counts. */
TEST(tiny_thick_lines)
{
    uint32_t hit = 0;
    for (struct cases c = cases_of(50000); cases_next(&c);) {
        struct random *r = &c.random;
        const int32_t x = random_between(r, 110, 146);
        const int32_t y = random_between(r, 110, 146);
        const int32_t reach = random_between(r, 0, 24);
        const struct any_shape s = {
            .kind = ANY_THICK_LINE,
            .v = {{x, y},
                  {x + random_between(r, -reach, reach),
                   y + random_between(r, -reach, reach)}},
            .radius = random_between(r, 0, 24)};
        const bool want = any_reference_at(&s, 0, 0);
        hit += want;
        if (any_hit(&s, 0, 0) != want)
            fail_msg("%d, %d to %d, %d, width %d: expected %d; %s", s.v[0].x,
                     s.v[0].y, s.v[1].x, s.v[1].y, s.radius, want,
                     cases_replay());
    }
    assert_true(hit > 0);
}

/* Nearly level lines, whose corners are rounded towards them by up to half a
 * sub-pixel, and a pixel at about half the width from them. */
TEST(edges_of_thick_lines)
{
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        struct random *r = &c.random;
        const int32_t half = random_between(r, 3, 300);
        const int32_t dx = random_between(r, 200, 3000);
        const int32_t slope = random_between(r, 80, 200);
        const int32_t dy = (int32_t)(dx * real_root(slope / 100.0L / half));
        const real length = real_root((real)dx * dx + (real)dy * dy);
        const real away = half - random_between(r, 0, 2000) / 1000.0L;
        const int32_t x = 128 - dx / 2 + (int32_t)(away * dy / length);
        const int32_t y = 128 - dy / 2 - (int32_t)(away * dx / length);
        const bool steep = random_word(r) % 2;
        const struct any_shape s = {
            .kind = ANY_THICK_LINE,
            .v = {{steep ? y : x, steep ? x : y},
                  {steep ? y + dy : x + dx, steep ? x + dx : y + dy}},
            .radius = 2 * half + random_between(r, 0, 1)};
        const bool want = any_reference_at(&s, 0, 0);
        if (any_hit(&s, 0, 0) != want)
            fail_msg("%d, %d to %d, %d, width %d: expected %d; %s", s.v[0].x,
                     s.v[0].y, s.v[1].x, s.v[1].y, s.radius, want,
                     cases_replay());
    }
}

/* Near the end of the range, where one sub-pixel more puts a corner out of it,
 * and nothing is covered. */
TEST(thick_lines_at_the_end)
{
    for (int32_t width = 0; width < 3000; width += 1 + width / 16)
        for (int32_t y = PEL_COORDINATE_MAX - width / 2 - 3;
             y <= PEL_COORDINATE_MAX; y++) {
            const struct any_shape s = {.kind = ANY_THICK_LINE,
                                        .v = {{-3000, y}, {3000, y}},
                                        .radius = width};
            for (int32_t row = 32767; row > 32755; row--)
                assert_int_equal(any_hit(&s, 0, row),
                                 any_reference_at(&s, 0, row));
        }
}
