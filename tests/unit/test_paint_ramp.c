/* Ramps from stops: exact colors, errors. */
#include "core/paint/gradient.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"

__extension__ typedef __int128 wide;

/* The color at 65,536 (2 i + 1) / 2 n, by looking for the stops around it. */
static uint32_t channel_at(const struct pel_stop *s, int32_t count, int32_t i,
                           int32_t n, int shift)
{
    wide at = (wide)65536 * (2 * i + 1), unit = 2 * (wide)n;
    for (int32_t k = count - 1; k >= 0; k--) {
        if (s[k].at * unit > at)
            continue;
        wide a = s[k].color >> shift & 255;
        if (k == count - 1)
            return (uint32_t)a;
        wide b = s[k + 1].color >> shift & 255;
        wide length = (s[k + 1].at - s[k].at) * unit;
        wide twice = 2 * (a * length + (b - a) * (at - s[k].at * unit));
        return (uint32_t)((twice + length) / (2 * length));
    }
    return s[0].color >> shift & 255;
}

static void check_ramp(const struct pel_stop *s, int32_t count, int32_t n)
{
    static pel_color ramp[4096];
    assert_int_equal(pel_ramp_fill(ramp, n, s, count), PEL_OK);
    for (int32_t i = 0; i < n; i++)
        for (int shift = 0; shift < 32; shift += 8) {
            uint32_t want = channel_at(s, count, i, n, shift);
            if ((ramp[i] >> shift & 255) != want)
                fail_msg("cell %d of %d, channel %d: expected %u, got %08x; %s",
                         i, n, shift / 8, want, ramp[i], cases_replay());
        }
}

/* Stops at one place among them: the later color from there on. */
TEST(exact)
{
    for (struct cases c = cases_of(2000); cases_next(&c);) {
        struct random *r = &c.random;
        struct pel_stop s[8];
        const int32_t count = random_between(r, 1, 8);
        int32_t at = random_between(r, 0, 1) * random_between(r, 0, 30000);
        for (int32_t i = 0; i < count; i++) {
            s[i] = (struct pel_stop){at, random_word(r)};
            if (random_word(r) % 4)
                at = random_between(r, at, 65536);
        }
        check_ramp(s, count, random_between(r, 1, c.next % 16 ? 300 : 4096));
    }
}

/* In the very middle of a cell the later color counts. */
TEST(hard_edge_in_the_middle)
{
    static const struct pel_stop s[] = {
        {0, 0xFF000000}, {32768, 0xFF000000}, {32768, 0xFFFFFFFF}};
    pel_color ramp[1];
    assert_int_equal(pel_ramp_fill(ramp, 1, s, 3), PEL_OK);
    assert_int_equal(ramp[0], 0xFFFFFFFF);
}

TEST(largest)
{
    static struct pel_stop s[32768];
    static pel_color ramp[32767];
    for (int i = 0; i < 32768; i++)
        s[i] = (struct pel_stop){i, 0x80000000u + (pel_color)i};
    assert_int_equal(pel_ramp_fill(ramp, 32767, s, 32767), PEL_OK);
    assert_int_equal(ramp[32766], 0x80000000u + 32766);
    assert_int_equal(pel_ramp_fill(ramp, 3, s, 32768), PEL_ERROR_SIZE);
}

TEST(errors)
{
    pel_color ramp[4];
    struct pel_stop s[2] = {{10, 0}, {9, 0}};
    assert_int_equal(pel_ramp_fill(NULL, 4, s, 1), PEL_ERROR_NULL);
    assert_int_equal(pel_ramp_fill(ramp, 4, NULL, 1), PEL_ERROR_NULL);
    assert_int_equal(pel_ramp_fill(ramp, 0, s, 1), PEL_ERROR_SIZE);
    assert_int_equal(pel_ramp_fill(ramp, 32768, s, 1), PEL_ERROR_SIZE);
    assert_int_equal(pel_ramp_fill(ramp, 4, s, 0), PEL_ERROR_SIZE);
    assert_int_equal(pel_ramp_fill(ramp, 4, s, 2), PEL_ERROR_RANGE);
    s[1].at = 65537;
    assert_int_equal(pel_ramp_fill(ramp, 4, s, 2), PEL_ERROR_RANGE);
    s[0].at = -1;
    assert_int_equal(pel_ramp_fill(ramp, 4, s, 1), PEL_ERROR_RANGE);
}
