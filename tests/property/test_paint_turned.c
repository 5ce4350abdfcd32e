/* Turned pictures: every pixel shows the texel that is there, by arithmetic of
 * its own; every one inside is painted once, and none outside. */
#include <math.h>

#include "core/pel.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"
#include "tests/support/layouts.h"
#include "tests/support/shapes.h"

enum { SIDE = 48, MOST = 24 };

static pel_color colors[MOST * MOST];
static uint32_t memory[SIDE * SIDE];

struct texel_point {
    long double u, v; /* texels */
};

/* What is shown at the centre of a pixel. */
static struct texel_point texel_of(const struct pel_turned_picture *p,
                                   int32_t x, int32_t y)
{
    const struct pel_point d = pel_direction((uint16_t)p->turn);
    const long double right = x * 256 + 128 - p->at.x;
    const long double down = y * 256 + 128 - p->at.y;
    const long double size = 65536.0L / p->scale / 32768 / 256;
    const struct texel_point at = {
        (right * d.x + down * d.y) * size + p->pivot.u / 256.0L,
        (down * d.x - right * d.y) * size + p->pivot.v / 256.0L};
    return at;
}

static struct pel_turned_picture random_picture(struct random *r)
{
    struct pel_turned_picture p = {
        .texels = {NULL, colors, random_between(r, 1, MOST),
                   random_between(r, 1, MOST), false},
        .pivot = {random_between(r, -3000, 6000),
                  random_between(r, -3000, 6000)},
        .at = {random_between(r, -2000, SIDE * 256),
               random_between(r, -2000, SIDE * 256)},
        .turn = random_between(r, -100000, 100000),
        .scale = random_between(r, 4096, 500000)};
    if (random_word(r) % 2)
        p.scale = PEL_SCALE_ONE << random_word(r) % 3;
    if (random_word(r) % 4 == 0)
        p.turn = random_between(r, -4, 4) * 16384;
    return p;
}

static int32_t inside(int32_t i, int32_t n)
{
    return pel_max(0, pel_min(i, n - 1));
}

static long double larger(long double a, long double b)
{
    return a > b ? a : b;
}

/* Is the texel that was seen the one at `at`, within `off` texels? */
static bool is_texel(const struct pel_turned_picture *p, struct texel_point at,
                     long double off, pel_color seen)
{
    for (int i = 0; i < 4; i++) {
        const long double u = floorl(at.u + (i & 1 ? off : -off));
        const long double v = floorl(at.v + (i & 2 ? off : -off));
        const int32_t column = inside((int32_t)u, p->texels.width);
        const int32_t row = inside((int32_t)v, p->texels.height);
        if (p->texels.colors[row * p->texels.width + column] == seen)
            return true;
    }
    return false;
}

/* How far a place is outside of the picture, px; negative inside. */
static long double outside(const struct pel_turned_picture *p,
                           struct texel_point at)
{
    const long double u = larger(-at.u, at.u - p->texels.width);
    const long double v = larger(-at.v, at.v - p->texels.height);
    return larger(u, v) * p->scale / 65536;
}

TEST(texels_are_where_they_belong)
{
    for (int i = 0; i < MOST * MOST; i++)
        colors[i] = PEL_RGB(i, i >> 8, 200); /* each another one */
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        const struct pel_turned_picture p = random_picture(&c.random);
        shape_keep(&p.at, 1);
        const struct pel_surface screen =
            surface_of(&pel_xrgb8888, memory, sizeof memory, SIDE, SIDE);
        pel_clear(&screen, 0);
        assert_int_equal(pel_turned_picture_draw(&screen, &p), PEL_OK);
        for (int32_t i = 0; i < SIDE * SIDE; i++) {
            const struct texel_point at = texel_of(&p, i % SIDE, i / SIDE);
            const long double rim = outside(&p, at);
            const bool painted = memory[i] != PEL_RGB(0, 0, 0);
            if ((rim > 0.01L && painted) || (rim < -0.01L && !painted) ||
                (painted && !is_texel(&p, at, 1 / 8192.0L, memory[i])))
                fail_msg("pixel %d, %d shows %08x; turn %d, scale %d: %s",
                         i % SIDE, i / SIDE, (unsigned)memory[i], p.turn,
                         p.scale, cases_replay());
        }
    }
}

/* Translucent halves share no pixel: painted twice, one would be brighter. */
TEST(no_pixel_twice)
{
    for (int i = 0; i < MOST * MOST; i++)
        colors[i] = PEL_RGBA(255, 255, 255, 128);
    for (struct cases c = cases_of(5000); cases_next(&c);) {
        struct pel_turned_picture p = random_picture(&c.random);
        const struct pel_surface screen =
            surface_of(&pel_gray8, memory, sizeof memory, SIDE, SIDE);
        const uint8_t *seen = (const uint8_t *)memory;
        p.bilinear = random_word(&c.random) % 2;
        pel_clear(&screen, 0);
        assert_int_equal(pel_turned_picture_draw(&screen, &p), PEL_OK);
        for (int i = 0; i < SIDE * SIDE; i++)
            if (seen[i] != 0 && seen[i] != 128)
                fail_msg("grey %d at %d, %d; turn %d, scale %d: %s", seen[i],
                         i % SIDE, i / SIDE, p.turn, p.scale, cases_replay());
    }
}

TEST(unturned_is_a_copy)
{
    uint16_t picture[MOST * MOST], copied[SIDE * SIDE], turned[SIDE * SIDE];
    for (struct cases c = cases_of(1000); cases_next(&c);) {
        const struct pel_surface source =
            surface_of(&pel_rgb565_le, picture, sizeof picture, MOST, MOST);
        const struct pel_surface screen[2] = {
            surface_of(&pel_rgb565_le, copied, sizeof copied, SIDE, SIDE),
            surface_of(&pel_rgb565_le, turned, sizeof turned, SIDE, SIDE)};
        const int32_t x = random_between(&c.random, -30, SIDE),
                      y = random_between(&c.random, -30, SIDE);
        const struct pel_turned_picture p = {.texels = {.surface = &source},
                                             .at = {PEL_PX(x), PEL_PX(y)},
                                             .scale = PEL_SCALE_ONE};
        const struct pel_copy_part part = {&source, source.bounds, x, y};
        for (int i = 0; i < MOST * MOST; i++)
            picture[i] = (uint16_t)random_word(&c.random);
        for (int i = 0; i < SIDE * SIDE; i++)
            copied[i] = turned[i] = 0x1234;
        pel_copy(&screen[0], &part);
        assert_int_equal(pel_turned_picture_draw(&screen[1], &p), PEL_OK);
        assert_memory_equal(copied, turned, sizeof copied);
    }
}

TEST(errors)
{
    const struct pel_surface screen =
        surface_of(&pel_xrgb8888, memory, sizeof memory, SIDE, SIDE);
    const struct pel_turned_picture good = {
        .texels = {NULL, colors, 8, 8, false}, .scale = PEL_SCALE_ONE};
    struct pel_turned_picture p = good;
    assert_int_equal(pel_turned_picture_draw(NULL, &p), PEL_ERROR_NULL);
    assert_int_equal(pel_turned_picture_draw(&screen, NULL), PEL_ERROR_NULL);
    p.scale = 4095;
    assert_int_equal(pel_turned_picture_draw(&screen, &p), PEL_ERROR_RANGE);
    p.scale = (1 << 24) + 1;
    assert_int_equal(pel_turned_picture_draw(&screen, &p), PEL_ERROR_RANGE);
    p = good;
    p.at.x = PEL_COORDINATE_MAX; /* the right corners lie beyond */
    assert_int_equal(pel_turned_picture_draw(&screen, &p), PEL_ERROR_RANGE);
    p = good;
    p.pivot.v = INT32_MIN;
    assert_int_equal(pel_turned_picture_draw(&screen, &p), PEL_ERROR_RANGE);
    p = good;
    p.texels.width = 0;
    assert_int_equal(pel_turned_picture_draw(&screen, &p), PEL_ERROR_SIZE);
}

/* Points that are turned and ends of hands, by floating point. */
TEST(points_turn)
{
    for (struct cases c = cases_of(100000); cases_next(&c);) {
        struct random *r = &c.random;
        const struct pel_point p = {random_between(r, -8388608, 8388607),
                                    random_between(r, -8388608, 8388607)};
        const struct pel_point center = {random_between(r, -8388608, 8388607),
                                         random_between(r, -8388608, 8388607)};
        const int32_t turn = random_between(r, -200000, 200000);
        const struct pel_point d = pel_direction((uint16_t)turn);
        const struct pel_point to = pel_turned(p, center, turn);
        const long double x = p.x - center.x, y = p.y - center.y;
        const long double right = (x * d.x - y * d.y) / 32768 + center.x;
        const long double down = (x * d.y + y * d.x) / 32768 + center.y;
        if (to.x != (int32_t)floorl(right + 0.5L) ||
            to.y != (int32_t)floorl(down + 0.5L))
            fail_msg("%d, %d about %d, %d by %d: %s", p.x, p.y, center.x,
                     center.y, turn, cases_replay());
    }
    const struct pel_point end =
        pel_polar((struct pel_point)PEL_AT(5, 7), PEL_PX(3), PEL_DEGREES(90));
    assert_int_equal(end.x, PEL_PX(5));
    assert_int_equal(end.y, PEL_PX(10));
    assert_int_equal(PEL_DEGREES(-45), -8192);
    assert_int_equal(PEL_DEGREES(0.5), 91);
}
