/* Patterns and nine-slice pictures: each color is the one that the header's
 * words give, worked out pixel by pixel, in whatever runs it is asked for. */
#include <stdio.h>

#include "tests/support/any_paint.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"
#include "tests/support/layouts.h"

enum { RUN = 90 };

struct pattern {
    int64_t v[5]; /* of a checker x, y, width, height; of a hatch dx, dy,
                     phase, period, width */
    pel_color on, off;
    enum { CHECKER, HATCH } kind;
    union any_paint paint;
};

static struct pattern p;

static void print(const void *value)
{
    const struct pattern *const s = value;
    fprintf(stderr, "kind %d, %lld %lld %lld %lld %lld\n", (int)s->kind,
            (long long)s->v[0], (long long)s->v[1], (long long)s->v[2],
            (long long)s->v[3], (long long)s->v[4]);
}

/* Small as often as not. */
static int32_t number(struct random *r, int32_t low, int32_t high)
{
    if (random_word(r) % 2)
        return random_between(r, low, high);
    return random_between(r, pel_max(low, -9), pel_min(high, 9));
}

/* The quotient rounded down, of y > 0. */
static int64_t floored(int64_t x, int64_t y)
{
    return x >= 0 ? x / y : -((-x + y - 1) / y);
}

static bool is_on(int64_t x, int64_t y)
{
    const int64_t *const v = p.v;
    if (p.kind == CHECKER)
        return ((floored(x - v[0], v[2]) + floored(y - v[1], v[3])) & 1) == 0;
    const int64_t t = v[0] * x + v[1] * y + v[2];
    return t - floored(t, v[3]) * v[3] < v[4];
}

static struct pel_color_paint *make(struct random *r)
{
    p.on = random_word(r) | (random_word(r) & 0xFF000000);
    p.off = random_word(r) | (random_word(r) & 0xFF000000);
    p.kind = random_word(r) % 2 ? CHECKER : HATCH;
    if (p.kind == CHECKER) {
        const struct pel_checker_fields f = {
            number(r, 1, 32767), number(r, 1, 32767),
            number(r, INT32_MIN, INT32_MAX), number(r, INT32_MIN, INT32_MAX)};
        const int64_t v[5] = {f.x, f.y, f.width, f.height, 0};
        for (int i = 0; i < 5; i++)
            p.v[i] = v[i];
        assert_int_equal(pel_checker_init(&p.paint.checker, &f, p.on, p.off),
                         PEL_OK);
    } else {
        struct pel_hatch_lines l = {number(r, -255, 255), number(r, -255, 255),
                                    number(r, INT32_MIN, INT32_MAX),
                                    number(r, 1, 32767), 0};
        l.width = number(r, 0, l.period);
        const int64_t v[5] = {l.dx, l.dy, l.phase, l.period, l.width};
        for (int i = 0; i < 5; i++)
            p.v[i] = v[i];
        assert_int_equal(pel_hatch_init(&p.paint.hatch, &l, p.on, p.off),
                         PEL_OK);
    }
    cases_keep(print, &p, sizeof p < CASES_PART ? sizeof p : CASES_PART);
    return &p.paint.colors;
}

TEST(patterns)
{
    for (struct cases c = cases_of(100000); cases_next(&c);) {
        struct random *const r = &c.random;
        const struct pel_color_paint *const paint = make(r);
        const int32_t n = random_between(r, 1, RUN);
        const int32_t x = number(r, -32768, 32768 - RUN),
                      y = number(r, -32768, 32767);
        pel_color got[RUN];
        if (paint->opaque && pel_alpha(p.on & p.off) != 255)
            fail_msg("not opaque; %s", cases_replay());
        paint->colors(paint, x, y, n, got);
        for (int32_t i = 0; i < n; i++)
            if (got[i] != (is_on(x + i, y) ? p.on : p.off))
                fail_msg("(%d, %d): %08x; %s", x + i, y, (unsigned)got[i],
                         cases_replay());
    }
}

struct side {
    int32_t from, to;       /* px of the picture */
    int32_t middle, behind; /* px of it where the middle begins and ends */
    int32_t low, high;      /* px of the screen */
};

/* Texel of a pixel inside of the box, as the header says. */
static int32_t texel_of(const struct side *s, bool tiled, int32_t x)
{
    const int32_t before = s->middle - s->from, right = s->to - s->behind;
    const int32_t middle = s->behind - s->middle;
    const int32_t room = s->high - s->low - before - right;
    if (x - s->low < before)
        return s->from + x - s->low;
    if (s->high - x <= right)
        return s->to - (s->high - x);
    const int32_t inside = x - s->low - before;
    if (tiled)
        return s->middle + inside % middle;
    return s->middle +
           (int32_t)((2 * (int64_t)inside + 1) * middle / (2 * room));
}

static struct side random_side(struct random *r, int32_t from, int32_t size)
{
    struct side s = {.from = from, .to = from + size};
    s.middle = random_between(r, s.from, s.to - 1);
    s.behind = random_between(r, s.middle + 1, s.to);
    s.low = number(r, -32768, 32767);
    s.high = s.low + number(r, 1, pel_min(32767, 32768 - s.low));
    return s;
}

TEST(slices)
{
    enum { WIDTH = 16, HEIGHT = 11 };
    static uint32_t texels[WIDTH * HEIGHT];
    for (struct cases c = cases_of(60000); cases_next(&c);) {
        struct random *const r = &c.random;
        const struct pel_rect all = {-4, 3, -4 + WIDTH, 3 + HEIGHT};
        const struct side a = random_side(r, all.x0, WIDTH),
                          d = random_side(r, all.y0, HEIGHT);
        const struct pel_rect middle = {a.middle, d.middle, a.behind, d.behind};
        const struct pel_rect box = {a.low, d.low, a.high, d.high};
        const bool tiled = random_word(r) % 2;
        const int32_t n = random_between(r, 1, RUN);
        const int32_t x = a.low + random_between(r, -9, 60),
                      y = d.low + random_between(r, -2, 40);
        struct pel_surface picture;
        struct pel_nine_slice paint;
        pel_color got[RUN];
        for (int i = 0; i < WIDTH * HEIGHT; i++)
            texels[i] = random_word(r);
        assert_int_equal(pel_surface_init(&picture, &pel_argb8888, texels,
                                          sizeof texels, &all),
                         PEL_OK);
        assert_int_equal(pel_nine_slice_init(&paint, &picture, &middle, &box),
                         PEL_OK);
        paint.tiled = tiled;
        paint.base.colors(&paint.base, x, y, n, got);
        for (int32_t i = 0; i < n; i++) {
            const bool inside =
                x + i >= box.x0 && x + i < box.x1 && y >= box.y0 && y < box.y1;
            const pel_color expected =
                inside ? texels[(texel_of(&d, tiled, y) - all.y0) * WIDTH +
                                texel_of(&a, tiled, x + i) - all.x0]
                       : 0;
            if (got[i] != expected)
                fail_msg("(%d, %d): %08x, not %08x; box %d %d %d %d, middle "
                         "%d %d %d %d, %d; %s",
                         x + i, y, (unsigned)got[i], (unsigned)expected, box.x0,
                         box.y0, box.x1, box.y1, middle.x0, middle.y0,
                         middle.x1, middle.y1, tiled, cases_replay());
        }
    }
}

TEST(errors)
{
    static uint16_t words[4];
    const struct pel_rect two = {0, 0, 2, 2}, box = {0, 0, 9, 9},
                          beyond = {0, 1, 2, 3}, none = {1, 1, 1, 2},
                          wide = {-1, 0, 32767, 1};
    const struct pel_checker_fields fields = {1, 32767, INT32_MIN, INT32_MAX},
                                    flat = {0, 1, 0, 0},
                                    high = {1, 32768, 0, 0};
    const struct pel_hatch_lines lines = {255, -255, INT32_MIN, 32767, 32767};
    struct pel_hatch_lines l = lines;
    struct pel_checker checker;
    struct pel_hatch hatch;
    struct pel_nine_slice slices;
    struct pel_surface s =
        surface_of(&pel_rgb565_le, words, sizeof words, 2, 2);
    assert_int_equal(pel_checker_init(&checker, &fields, 0, 0), PEL_OK);
    assert_int_equal(pel_checker_init(NULL, &fields, 0, 0), PEL_ERROR_NULL);
    assert_int_equal(pel_checker_init(&checker, NULL, 0, 0), PEL_ERROR_NULL);
    assert_int_equal(pel_checker_init(&checker, &flat, 0, 0), PEL_ERROR_RANGE);
    assert_int_equal(pel_checker_init(&checker, &high, 0, 0), PEL_ERROR_RANGE);
    assert_ptr_equal(checker.base.paint.fill, pel_nothing_fill);
    assert_int_equal(pel_hatch_init(&hatch, &l, 0, 0), PEL_OK);
    assert_int_equal(pel_hatch_init(NULL, &l, 0, 0), PEL_ERROR_NULL);
    assert_int_equal(pel_hatch_init(&hatch, NULL, 0, 0), PEL_ERROR_NULL);
    l.dx = 256;
    assert_int_equal(pel_hatch_init(&hatch, &l, 0, 0), PEL_ERROR_RANGE);
    l = lines;
    l.dy = -256;
    assert_int_equal(pel_hatch_init(&hatch, &l, 0, 0), PEL_ERROR_RANGE);
    l = lines;
    l.period = 32768;
    assert_int_equal(pel_hatch_init(&hatch, &l, 0, 0), PEL_ERROR_RANGE);
    l = lines;
    l.period = 0;
    assert_int_equal(pel_hatch_init(&hatch, &l, 0, 0), PEL_ERROR_RANGE);
    l = lines;
    l.width = -1;
    assert_int_equal(pel_hatch_init(&hatch, &l, 0, 0), PEL_ERROR_RANGE);
    assert_ptr_equal(hatch.base.paint.fill, pel_nothing_fill);
    assert_int_equal(pel_nine_slice_init(&slices, &s, &two, &box), PEL_OK);
    assert_int_equal(pel_nine_slice_init(NULL, &s, &two, &box), PEL_ERROR_NULL);
    assert_int_equal(pel_nine_slice_init(&slices, NULL, &two, &box),
                     PEL_ERROR_NULL);
    assert_int_equal(pel_nine_slice_init(&slices, &s, NULL, &box),
                     PEL_ERROR_NULL);
    assert_int_equal(pel_nine_slice_init(&slices, &s, &two, NULL),
                     PEL_ERROR_NULL);
    assert_int_equal(pel_nine_slice_init(&slices, &s, &beyond, &box),
                     PEL_ERROR_RANGE);
    assert_int_equal(pel_nine_slice_init(&slices, &s, &none, &box),
                     PEL_ERROR_RANGE);
    assert_int_equal(pel_nine_slice_init(&slices, &s, &two, &wide),
                     PEL_ERROR_RANGE);
    s.format = &pel_rgb565_le_fill;
    assert_int_equal(pel_nine_slice_init(&slices, &s, &two, &box),
                     PEL_ERROR_FORMAT);
    assert_ptr_equal(slices.base.paint.fill, pel_nothing_fill);
}
