/* Hit tests: a list of targets, pixels out of range. That each equals its
 * fill is tested with the fills (property/test_shape_coverage). */
#include "core/hit/hit.h"
#include "tests/support/check.h"

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

static void test_topmost(void **state)
{
    (void)state;
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
    asked = 0;
    pel_hit_topmost(list, 3, 65, 50);
    assert_int_equal(asked, 1);
}

/* A target with a box is asked inside of it, all others everywhere. */
static void test_boxes(void **state)
{
    (void)state;
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

static void test_pixels_out_of_range(void **state)
{
    (void)state;
    static const int32_t far[] = {INT32_MIN, -32769, 32768, INT32_MAX};
    const struct pel_point origin = {0, 0}, end = PEL_AT(1, 1);
    for (int i = 0; i < 4; i++) {
        assert_false(pel_hit_circle(origin, PEL_PX(32767), far[i], 0));
        assert_false(pel_hit_circle(origin, PEL_PX(32767), 0, far[i]));
        assert_false(pel_hit_line(origin, end, far[i], 0));
        assert_false(pel_hit_rectangle(origin, end, 0, far[i]));
    }
    assert_true(pel_hit_rectangle((struct pel_point){-8388608, -8388608},
                                  (struct pel_point){8388607, 8388607}, -32768,
                                  32766));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_topmost),
        cmocka_unit_test(test_boxes),
        cmocka_unit_test(test_pixels_out_of_range),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
