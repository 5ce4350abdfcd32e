/* HSV to RGB against the rational form, written as the textbook has it. */
#include "core/base/color.h"
#include "tests/support/check.h"

/* n / d to the nearest whole number, a half upwards; n >= 0. */
static uint32_t rounded(int64_t n, int64_t d)
{
    return (uint32_t)((2 * n + d) / (2 * d));
}

/* Channel values are v (1 - s k), with k the distance, in sixths of the turn
 * and between 0 and 1, by which the hue is out of the channel's reach. The
 * reach is a sixth on both sides of the channel's own hue; hue and turn are in
 * sixths times `sixth`. */
static uint32_t channel(int64_t hue, int64_t own, int64_t sixth, int64_t s,
                        int64_t v)
{
    int64_t turn = 6 * sixth, away = hue - own * sixth;
    away = ((away % turn) + turn) % turn;
    if (away > turn / 2)
        away = turn - away;
    int64_t k = away <= sixth ? 0 : away >= 2 * sixth ? sixth : away - sixth;
    return rounded(v * (255 * sixth - s * k), 255 * sixth);
}

static pel_color expected(int64_t hue, int64_t sixth, int64_t s, int64_t v)
{
    return PEL_RGB(channel(hue, 0, sixth, s, v), channel(hue, 2, sixth, s, v),
                   channel(hue, 4, sixth, s, v));
}

TEST(every_degree)
{
    for (int32_t hue = 0; hue < 360; hue++)
        for (uint32_t s = 0; s < 256; s++)
            for (uint32_t v = 0; v < 256; v++) {
                pel_color want = expected(hue, 60, s, v);
                pel_color got = pel_hsv_degrees(hue, s, v);
                if (got != want)
                    fail_msg("hue %d, s %u, v %u: expected %08x, got %08x", hue,
                             s, v, want, got);
            }
}

/* A sixth is 65,536 here: six times the hue in 1/65,536 turns. */
TEST(every_turn)
{
    for (int32_t hue = 0; hue < 65536; hue++)
        for (uint32_t s = (uint32_t)hue % 5 * 3; s < 256; s += 17)
            for (uint32_t v = (uint32_t)hue % 7 * 2; v < 256; v += 23) {
                pel_color want = expected(6 * (int64_t)hue, 65536, s, v);
                pel_color got = pel_hsv(hue, s, v);
                if (got != want)
                    fail_msg("hue %d, s %u, v %u: expected %08x, got %08x", hue,
                             s, v, want, got);
            }
    for (int32_t hue = 0; hue < 65536; hue++)
        assert_int_equal(pel_hsv(hue, 255, 255),
                         expected(6 * (int64_t)hue, 65536, 255, 255));
}

TEST(any_hue)
{
    for (int32_t hue = -4000; hue < 4000; hue++) {
        int32_t degrees = ((hue % 360) + 360) % 360;
        assert_int_equal(pel_hsv_degrees(hue, 200, 211),
                         pel_hsv_degrees(degrees, 200, 211));
    }
    for (int32_t hue = 0; hue < 65536; hue += 7) {
        pel_color want = pel_hsv(hue, 255, 255);
        assert_int_equal(pel_hsv(hue - 65536, 255, 255), want);
        assert_int_equal(pel_hsv(hue + 65536, 255, 255), want);
        assert_int_equal(pel_hsv(hue + INT32_MIN, 255, 255), want);
    }
    assert_int_equal(pel_hsv_degrees(INT32_MIN, 255, 255),
                     pel_hsv_degrees(INT32_MIN % 360 + 360, 255, 255));
    assert_int_equal(pel_hsv_degrees(INT32_MAX, 255, 255),
                     pel_hsv_degrees(INT32_MAX % 360, 255, 255));
}

TEST(corners)
{
    assert_int_equal(pel_hsv_degrees(0, 255, 255), PEL_RGB(255, 0, 0));
    assert_int_equal(pel_hsv_degrees(60, 255, 255), PEL_RGB(255, 255, 0));
    assert_int_equal(pel_hsv_degrees(120, 255, 255), PEL_RGB(0, 255, 0));
    assert_int_equal(pel_hsv_degrees(180, 255, 255), PEL_RGB(0, 255, 255));
    assert_int_equal(pel_hsv_degrees(240, 255, 255), PEL_RGB(0, 0, 255));
    assert_int_equal(pel_hsv_degrees(300, 255, 255), PEL_RGB(255, 0, 255));
    assert_int_equal(pel_hsv_degrees(77, 0, 93), PEL_RGB(93, 93, 93));
    assert_int_equal(pel_hsv_degrees(77, 255, 0), PEL_RGB(0, 0, 0));
}
