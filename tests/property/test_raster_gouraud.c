/* Interpolated colors against exact fractions: the bound of raster/gouraud.h,
 * before and after rounding. */

#include "tests/support/canvas.h"
#include "tests/support/check.h"
#include "tests/support/paint_math.h"
#include "tests/support/reference.h"
#include "tests/support/shapes.h"

/* The bound, in 2^-24 of a step: 2^-17 for every pixel of the way from the
 * pixel of the topmost vertex and one more, and 1/16 step. */
static int64_t bound_at(const struct pel_point v[3], int32_t x, int32_t y)
{
    const struct pel_point *top = &v[0];
    for (int i = 1; i < 3; i++)
        if (v[i].y < top->y || (v[i].y == top->y && v[i].x < top->x))
            top = &v[i];
    int64_t dx = x - pel_pixel_of(top->x), dy = y - pel_pixel_of(top->y);
    int64_t distance = (dx < 0 ? -dx : dx) + (dy < 0 ? -dy : dy) + 1;
    return distance < 8192 ? distance * 128 : 1048576;
}

/* The plane's error in 2^-24 of a step, rounded away from zero; the plane is
 * half a step high, since it is cut, not rounded. */
static int64_t error_at(const struct pel_gouraud *g, int k, int32_t x,
                        int32_t y, struct fraction exact)
{
    uint32_t value =
        g->at[k] + (uint32_t)x * g->dx[k] + (uint32_t)y * g->dy[k] - 0x800000u;
    wide scaled = exact.n * 16777216, whole = scaled / exact.d;
    int64_t error = (int32_t)(value - (uint32_t)whole);
    if (error < 0)
        return error - (scaled % exact.d != 0);
    return error;
}

struct tally {
    uint64_t channels;
    struct histogram errors; /* steps; the bound is 1/16 */
};

/* At x, y, of channel k; returns the size of the error. */
static int64_t check_plane(const struct pel_gouraud *g,
                           const struct pel_point v[3], const pel_color c[3],
                           const int32_t at[3])
{
    const int32_t x = at[0], y = at[1];
    const int64_t error =
        error_at(g, at[2], x, y, reference_channel_at(v, c, at[2], x, y));
    const int64_t size = error < 0 ? -error : error;
    if (size > bound_at(v, x, y))
        fail_msg("channel %d at %d, %d: off by %lld / 2^24, bound %lld; "
                 "%d,%d %d,%d %d,%d; %s",
                 at[2], x, y, (long long)error, (long long)bound_at(v, x, y),
                 v[0].x, v[0].y, v[1].x, v[1].y, v[2].x, v[2].y,
                 cases_replay());
    return size;
}

static void check_channel(struct tally *t, const struct pel_gouraud *g,
                          const struct pel_point v[3], const pel_color c[3],
                          const int32_t at[3])
{
    const int32_t x = at[0], y = at[1];
    const int k = at[2];
    const struct fraction exact = reference_channel_at(v, c, k, x, y);
    const int64_t size = check_plane(g, v, c, at);
    const int64_t best = (int64_t)((2 * exact.n + exact.d) / (2 * exact.d));
    const int64_t got = canvas_gouraud(g, x, y) >> 8 * k & 255;
    if (got < best - 1 || got > best + 1)
        fail_msg("channel %d at %d, %d: expected %d, got %d; %s", k, x, y,
                 (int)best, (int)got, cases_replay());
    t->channels++;
    histogram_add(&t->errors, (real)size / 16777216);
}

static void check_window(struct tally *t, const struct pel_point v[3],
                         const pel_color c[3], const struct pel_rect *w)
{
    struct pel_gouraud g;
    pel_gouraud_init(&g, v, c);
    for (int32_t y = w->y0; y < w->y1; y++)
        for (int32_t x = w->x0; x < w->x1; x++) {
            if (!reference_triangle_at(v, x, y))
                continue;
            for (int32_t k = 0; k < 4; k++)
                check_channel(t, &g, v, c, (const int32_t[]){x, y, k});
        }
}

static void random_colors(struct random *r, pel_color c[3])
{
    const uint32_t kind = random_word(r) % 4;
    for (int i = 0; i < 3; i++) {
        c[i] = random_word(r);
        if (kind == 0) /* the steepest: 0 and 255 alone */
            c[i] = (c[i] >> 7 & 0x01010101u) * 255;
        else if (kind == 1) /* next to opaque */
            c[i] |= 0xFEFEFEFEu;
    }
}

typedef void generator(struct random *r, struct pel_point *v, int32_t n);

static void check_bound(const char *name, generator *generate, uint64_t count)
{
    struct tally t = {0, {.name = name, .step = 0x1p-10L}};
    for (struct cases c = cases_of(count); cases_next(&c);) {
        struct pel_point v[3];
        pel_color color[3];
        generate(&c.random, v, 3);
        random_colors(&c.random, color);
        const struct pel_rect w = shape_window(&c.random, v, 3, 10);
        check_window(&t, v, color, &w);
    }
    histogram_end(&t.errors);
    assert_true(cases_alone() || t.channels > 0);
}

TEST(random)
{
    check_bound("gouraud_random", shape_random, 400000);
}

TEST(adversarial)
{
    check_bound("gouraud_adversarial", shape_adversarial, 400000);
}

/* Around the two borders between reciprocal and long division: 4,096 px, and
 * an area of 16 times the longer side. */
static void borders(struct random *r, struct pel_point *v, int32_t n)
{
    (void)n;
    int32_t side = random_word(r) % 2 ? 1048576 + random_between(r, -2, 2)
                                      : random_between(r, 256, 1048576);
    int32_t thin = random_between(r, 14, 18);
    int32_t x = random_between(r, -1048576, 1048576);
    int32_t y = random_between(r, -1048576, 1048576);
    int32_t slope = random_between(r, -1, 1);
    v[0] = (struct pel_point){x, y};
    v[1] = (struct pel_point){x + side, y + slope * side};
    v[2] = (struct pel_point){x + side / 2 - thin * slope,
                              y + slope * (side / 2) + thin};
    if (random_word(r) % 2)
        v[2] = (struct pel_point){x + random_between(r, -64, 64), y + side};
    if (random_word(r) % 2)
        for (int i = 0; i < 3; i++)
            v[i] = (struct pel_point){v[i].y, v[i].x};
}

TEST(borders)
{
    check_bound("gouraud_borders", borders, 200000);
}

/* Slivers along a diagonal, a few sub-pixels wide: the steepest gradients that
 * there are. Inside they nearly cancel each other. */
static void slivers(struct random *r, struct pel_point v[3])
{
    const int32_t side = random_between(r, 256, 1048576);
    const int32_t x = random_between(r, -1048576, 1048576);
    const int32_t y = random_between(r, -1048576, 1048576);
    const int32_t slope = random_word(r) % 2 ? 1 : -1;
    const int32_t middle = random_between(r, side / 8, side);
    v[0] = (struct pel_point){x, y};
    v[1] = (struct pel_point){x + slope * side, y + side};
    v[2] = (struct pel_point){x + slope * middle,
                              y + middle + random_between(r, 1, 18)};
}

/* The plane goes on beyond the triangle, within the bound for each pixel. */
TEST(beyond_slivers)
{
    for (struct cases c = cases_of(100000); cases_next(&c);) {
        struct pel_point v[3];
        pel_color color[3];
        struct pel_gouraud g;
        slivers(&c.random, v);
        random_colors(&c.random, color);
        pel_gouraud_init(&g, v, color);
        for (int i = 0; i < 4; i++) {
            const int32_t x = random_between(&c.random, -4000, 4000);
            const int32_t y = random_between(&c.random, -4000, 4000);
            check_plane(&g, v, color,
                        (const int32_t[]){pel_pixel_of(v[0].x) + x,
                                          pel_pixel_of(v[0].y) + y, i});
        }
    }
}

/* What is drawn is the plane, cut to 8 bits, through clips and both walkers. */
TEST(bytes_are_the_plane)
{
    static struct canvas canvas;
    static struct hits hits;
    for (struct cases c = cases_of(30000); cases_next(&c);) {
        struct pel_point v[3];
        pel_color color[3];
        struct pel_gouraud g;
        shape_adversarial(&c.random, v, 3);
        random_colors(&c.random, color);
        const struct pel_rect w = shape_window(&c.random, v, 3, 24);
        canvas_open(&canvas, &pel_xrgb8888, &w,
                    random_word(&c.random) % CANVAS_STYLES);
        hits_open(&hits, &w);
        pel_triangle_gouraud(&canvas.surface, v, color);
        pel_triangle(&hits.surface, v, &hits.paint);
        pel_gouraud_init(&g, v, color);
        canvas_check_drawn(&canvas, &hits, canvas_gouraud, &g);
    }
}
