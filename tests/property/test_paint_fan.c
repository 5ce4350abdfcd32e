/* Fans against exact planes of their triangles. */
#include "core/paint/paint_fan.h"
#include "tests/support/check.h"
#include "tests/support/paint_math.h"
#include "tests/support/reference.h"
#include "tests/support/shapes.h"

static struct histogram errors = {.name = "fan_color", .step = 1.0L / 64};

enum { POINTS_MAX = 12 };

/* Channels that go farther beyond the perimeter are not promised. */
#define BEYOND 2147483648.0L

struct fan_case {
    struct pel_point v[POINTS_MAX];
    pel_color colors[POINTS_MAX];
    struct pel_fan_points points;
    struct pel_fan_triangle memory[POINTS_MAX];
    struct pel_fan fan;
};

static struct fan_case fan;

static wide cross(struct pel_point a, struct pel_point b, wide x, wide y)
{
    return ((wide)b.x - a.x) * (y - a.y) - ((wide)b.y - a.y) * (x - a.x);
}

/* A star around a hub: angles that grow, any radius; either direction. */
static void random_star(struct random *r)
{
    struct fan_case *f = &fan;
    const int32_t n = random_between(r, 3, POINTS_MAX);
    const int32_t size = PEL_PX(1) << random_between(r, 0, 12);
    const struct pel_point hub = {random_between(r, -4000000, 4000000),
                                  random_between(r, -4000000, 4000000)};
    const uint16_t start = (uint16_t)random_word(r);
    for (int32_t i = 0; i < n; i++) {
        struct pel_point all[POINTS_MAX];
        pel_fan_perimeter(all, n, hub, random_between(r, size / 4 + 4, size),
                          start);
        f->v[i] = all[i];
        f->colors[i] = random_word(r);
    }
    f->points =
        (struct pel_fan_points){hub, random_word(r), f->v, f->colors, n};
    const bool almost_one_color = random_word(r) % 4 == 0;
    for (int32_t i = 0; almost_one_color && i < n; i++)
        f->colors[i] = f->points.hub_color ^ (random_word(r) & 0x01010101);
    const bool reversed = random_word(r) % 2;
    for (int32_t i = 0; reversed && i < n / 2; i++) {
        struct pel_point t = f->v[i];
        f->v[i] = f->v[n - 1 - i];
        f->v[n - 1 - i] = t;
    }
}

/* The exact channel in the triangle of the hub, perimeter point i and the next,
 * which goes on beyond the perimeter; false when the pixel is not between their
 * rays. */
static bool channel_after(int32_t i, int32_t x, int32_t y, int k, real *value)
{
    const int32_t j = (i + 1) % fan.points.n;
    const struct pel_point h = fan.points.hub, a = fan.v[i], b = fan.v[j];
    const wide px = pel_pixel_center(x), py = pel_pixel_center(y);
    wide area = cross(h, a, b.x, b.y), to_b = cross(h, a, px, py),
         to_a = -cross(h, b, px, py);
    if (area < 0) {
        area = -area;
        to_a = -to_a;
        to_b = -to_b;
    }
    if (area == 0 || to_a < 0 || to_b < 0)
        return false;
    real ch = fan.points.hub_color >> 8 * k & 255;
    real ca = fan.colors[i] >> 8 * k & 255, cb = fan.colors[j] >> 8 * k & 255;
    *value =
        ch + ((ca - ch) * (real)to_a + (cb - ch) * (real)to_b) / (real)area;
    if (real_abs(*value) >= BEYOND)
        return false;
    *value = *value < 0 ? 0 : *value > 255 ? 255 : *value;
    return true;
}

static bool is_beyond(int32_t x, int32_t y, int k)
{
    real value = 0;
    for (int32_t i = 0; i < fan.points.n; i++)
        if (!channel_after(i, x, y, k, &value) && real_abs(value) >= BEYOND)
            return true;
    return false;
}

static void check_channel(int32_t x, int32_t y, int k, pel_color got)
{
    real best = 256, value;
    for (int32_t i = 0; i < fan.points.n; i++) {
        if (!channel_after(i, x, y, k, &value))
            continue;
        real error = (real)(got >> 8 * k & 255) - value;
        best = real_abs(error) < real_abs(best) ? error : best;
    }
    if (best == 256 && is_beyond(x, y, k))
        return;
    if (best == 256)
        best = (real)(got >> 8 * k & 255) -
               (real)(fan.points.hub_color >> 8 * k & 255);
    if (real_abs(best) > 0.5L + 0x1p-14L)
        fail_msg("hub %d,%d n %d, pixel %d,%d, channel %d: got %08x, %Lg off; "
                 "%s",
                 fan.points.hub.x, fan.points.hub.y, fan.points.n, x, y, k, got,
                 best, cases_replay());
    histogram_add(&errors, best);
}

static void check_runs(struct random *r)
{
    struct pel_color_paint *p = &fan.fan.base;
    int32_t x = pel_pixel_of(fan.points.hub.x) - 1, size = 4;
    int32_t y = pel_pixel_of(fan.points.hub.y) - 1;
    pel_color got[48], one;
    for (int turn = 0; turn < 8; turn++, size *= 3) {
        int32_t left = pel_max(-32768, x - random_between(r, 0, size));
        left = pel_min(left, 32767 - 48);
        int32_t line = y + random_between(r, -size, size);
        line = pel_max(-32768, pel_min(line, 32767));
        p->colors(p, left, line, 48, got);
        for (int32_t i = 0; i < 48; i++)
            for (int k = 0; k < 4; k++)
                check_channel(left + i, line, k, got[i]);
        for (int32_t i = 0; i < 48; i++) {
            p->colors(p, left + i, line, 1, &one);
            assert_int_equal(one, got[i]);
        }
    }
}

TEST(stars)
{
    for (struct cases c = cases_of(2500); cases_next(&c);) {
        random_star(&c.random);
        assert_int_equal(pel_fan_init(&fan.fan, &fan.points, fan.memory),
                         PEL_OK);
        check_runs(&c.random);
    }
    histogram_end(&errors);
}

/* Convex and not, any legal points: where the perimeter goes around the hub. */
TEST(any_triangle)
{
    for (struct cases c = cases_of(10000); cases_next(&c);) {
        struct random *r = &c.random;
        if (c.next % 2)
            shape_random(r, fan.v, 3);
        else
            shape_adversarial(r, fan.v, 3);
        for (int i = 0; i < 3; i++)
            fan.colors[i] = random_word(r);
        fan.points = (struct pel_fan_points){{0, 0}, 0, fan.v, fan.colors, 3};
        pel_fan_set_hub(&fan.points);
        if (pel_fan_init(&fan.fan, &fan.points, fan.memory) == PEL_OK)
            check_runs(r);
    }
}

TEST(hub_on_an_edge)
{
    const struct pel_point v[3] = {PEL_AT(0, 0), PEL_AT(20, 0), PEL_AT(10, 10)};
    const pel_color c[3] = {0xFF000000, 0xFFFFFFFF, 0xFF00FF00};
    pel_color got[40];
    fan.points = (struct pel_fan_points){PEL_AT(10, 0), 0xFF808080, v, c, 3};
    assert_int_equal(pel_fan_init(&fan.fan, &fan.points, fan.memory), PEL_OK);
    fan.fan.base.colors(&fan.fan.base, -10, -5, 40, got);
    for (int i = 0; i < 40; i++)
        assert_int_equal(got[i], 0xFF808080);
    fan.fan.base.colors(&fan.fan.base, 1, 0, 1, got);
    assert_in_range(got[0] & 255, 10, 22);
}

/* Half a turn around a hub on the edge, two points on one ray, rays through
 * pixel centres with colors between two steps there: where the list begins and
 * which way it goes changes nothing. In px from the hub. */
static const struct pel_point half[] = {{6, 0}, {8, 0},  {6, 6}, {10, 10},
                                        {0, 5}, {-3, 9}, {-5, 0}};
static const pel_color half_colors[] = {0xFF000600, 0xFF000800, 0xFF030003,
                                        0xFF050005, 0xFF010100, 0xFF000101,
                                        0xFFFA0000};
enum { HALF = sizeof half / sizeof *half, HALF_SIZE = 32 };

static void draw_half(int first, bool reversed, pel_color *out)
{
    const struct pel_point hub = {PEL_PX(12) + 128, PEL_PX(12) + 128};
    struct pel_point v[HALF];
    pel_color colors[HALF];
    for (int i = 0; i < HALF; i++) {
        const int k = (reversed ? first + HALF - i : first + i) % HALF;
        v[i].x = hub.x + PEL_PX(half[k].x);
        v[i].y = hub.y + PEL_PX(half[k].y);
        colors[i] = half_colors[k];
    }
    fan.points = (struct pel_fan_points){hub, 0xFF000000, v, colors, HALF};
    assert_int_equal(pel_fan_init(&fan.fan, &fan.points, fan.memory), PEL_OK);
    assert_true(fan.fan.base.opaque);
    for (int32_t i = 0; i < HALF_SIZE * HALF_SIZE; i++)
        fan.fan.base.colors(&fan.fan.base, i % HALF_SIZE, i / HALF_SIZE, 1,
                            out + i);
}

TEST(any_beginning)
{
    static pel_color want[HALF_SIZE * HALF_SIZE], got[HALF_SIZE * HALF_SIZE];
    draw_half(0, false, want);
    assert_int_equal(want[12 * HALF_SIZE + 12], 0xFF000000);
    assert_int_equal(want[12 * HALF_SIZE + 10], 0xFF640000); /* last ray */
    assert_int_equal(want[12 * HALF_SIZE + 15], 0xFF000300); /* first ray */
    assert_int_equal(want[11 * HALF_SIZE + 15], 0xFF000000); /* outside */
    for (int first = 0; first < HALF; first++)
        for (int reversed = 0; reversed < 2; reversed++) {
            draw_half(first, reversed, got);
            for (int i = 0; i < HALF_SIZE * HALF_SIZE; i++)
                if (got[i] != want[i])
                    fail_msg("from point %d, reversed %d, pixel %d, %d: %08x, "
                             "expected %08x",
                             first, reversed, i % HALF_SIZE, i / HALF_SIZE,
                             got[i], want[i]);
        }
}

TEST(opaque)
{
    const struct pel_point v[3] = {PEL_AT(0, 0), PEL_AT(20, 0), PEL_AT(10, 10)};
    for (int i = 0; i < 4; i++) {
        pel_color c[4] = {0xFF000000, 0xFF000000, 0xFF000000, 0xFF000000};
        c[i] = 0xFE000000;
        fan.points = (struct pel_fan_points){PEL_AT(10, 3), c[3], v, c, 3};
        assert_int_equal(pel_fan_init(&fan.fan, &fan.points, fan.memory),
                         PEL_OK);
        assert_false(fan.fan.base.opaque);
    }
}

TEST(largest)
{
    static struct pel_point v[32768];
    static pel_color colors[32768];
    static struct pel_fan_triangle triangles[32768];
    struct pel_fan_points p = {{0, 0}, 0, v, colors, 32767};
    pel_fan_perimeter(v, 32767, p.hub, PEL_PX(30000), 0);
    assert_int_equal(pel_fan_init(&fan.fan, &p, triangles), PEL_OK);
    p.n = 32768;
    pel_fan_perimeter(v, 32768, p.hub, PEL_PX(30000), 0);
    assert_int_equal(pel_fan_init(&fan.fan, &p, triangles), PEL_ERROR_SIZE);
}

/* Rims that go around once, from every point on and both ways: with a point on
 * the hub, and with points beside the level rays. The last goes a little more
 * than once around a hub that is one of its corners. */
TEST(perimeters_around_once)
{
    static const struct pel_point perimeters[3][5] = {
        {{900, 900}, {-900, 900}, {-900, -900}, {0, 0}, {900, -900}},
        {{900, 1}, {-900, 1}, {-900, 0}, {-900, -1}, {900, -1}},
        {{900, -400}, {0, 900}, {-900, -10}, {900, -300}, {0, 0}}};
    const pel_color hues[5] = {0, 0, 0, 0, 0};
    for (int k = 0; k < 3; k++)
        for (int first = 0; first < 5; first++)
            for (int way = -1; way <= 1; way += 2) {
                struct pel_point v[5];
                for (int i = 0; i < 5; i++)
                    v[i] = perimeters[k][(first + way * i + 5) % 5];
                const struct pel_fan_points p = {{0, 0}, 0, v, hues, 5};
                assert_int_equal(pel_fan_init(&fan.fan, &p, fan.memory),
                                 k < 2 ? PEL_OK : PEL_ERROR_RANGE);
            }
}
