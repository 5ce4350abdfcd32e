/* The bounds of rows and pixels hold for triangles of every kind, and are
 * tight where they are large. */
#include "core/raster/cost.h"

#include "core/pel.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"
#include "tests/support/shapes.h"

static uint32_t rows, pixels;

static void count(const struct pel_paint *paint, const struct pel_spans *spans)
{
    (void)paint;
    for (int32_t i = 0; i < spans->n; i++)
        if (spans->span[i].x0 < spans->span[i].x1) {
            rows++;
            pixels += (uint32_t)(spans->span[i].x1 - spans->span[i].x0);
        }
}

static const struct pel_format format = {.id = 200, .bits = 8};
static const struct pel_paint paint = {.fill = count};
static const struct pel_cost_rates rates = {1000, 0, 0, 10, 10, 100, 32};

static void check(const struct pel_point v[3], const struct pel_rect *clip,
                  double *tightest)
{
    const struct pel_surface surface = {
        .bounds = *clip, .clip = *clip, .format = &format};
    struct pel_cost cost = {0};
    rows = pixels = 0;
    pel_triangle(&surface, v, &paint);
    pel_triangle_cost(&cost, v, clip, &rates);
    if (rows > cost.rows || pixels > cost.pixels ||
        cost.instructions < 1000 + 110 * (uint64_t)rows + 2 * (uint64_t)pixels)
        fail_msg("%s: %u rows of %u, %u pixels of %u", cases_replay(), rows,
                 cost.rows, pixels, cost.pixels);
    if (cost.pixels && (double)pixels / cost.pixels > *tightest)
        *tightest = (double)pixels / cost.pixels;
}

/* In a box of that size, some as thin as a sub-pixel, on whole pixels, half of
 * them or any place. */
static void check_size(int32_t size, uint64_t n, double tight)
{
    static const int32_t grids[] = {1, 128, 256};
    const struct pel_rect all = {-16384, -16384, 16383, 16383};
    double tightest = 0;
    for (struct cases c = cases_of(n); cases_next(&c);) {
        const int32_t grid = grids[random_word(&c.random) % 3];
        const int32_t wide = random_word(&c.random) & 1 ? size : 300;
        const int32_t off = random_between(&c.random, 0, 255);
        struct pel_point v[3];
        for (int k = 0; k < 3; k++) {
            v[k].x = random_between(&c.random, 0, wide) / grid * grid + off;
            v[k].y = random_between(&c.random, 0, size) / grid * grid + off;
        }
        const int32_t px = size / 256;
        shape_keep(v, 3);
        const struct pel_rect cut = {px / 4, px / 3, px, px * 3 / 4 + 1};
        check(v, random_word(&c.random) & 1 ? &all : &cut, &tightest);
    }
    assert_true(cases_alone() || tightest >= tight);
}

TEST(sizes)
{
    check_size(300, 200000, 1);
    check_size(PEL_PX(8), 100000, .97);
    check_size(PEL_PX(100), 30000, .97);
    check_size(PEL_PX(16000), 300, .99);
}
