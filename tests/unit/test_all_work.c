/* Work is bounded by what is visible: the rows, runs and pixels that huge
 * shapes hand to a paint through a small clip. What cannot be counted from
 * outside is done so often that a walk over the invisible would not end. */
#define _DEFAULT_SOURCE /* alarm */
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

#include "core/outline/outline_filter.h"
#include "core/raster/collect.h"
#include "tests/support/any_shape.h"
#include "tests/support/check.h"
#include "tests/support/cases.h"
#include "tests/support/hits.h"
#include "tests/support/reference.h"

enum { SIDE = 6, TIMES = 200000, TOO_LONG = 120 };

static struct hits hits;

/* Batches of n runs, for shapes that collect up to so many runs in one. */
static uint64_t batches_of(uint64_t n, uint64_t runs)
{
    return (n + runs - 1) / runs;
}

enum { low = PEL_COORDINATE_MIN, high = PEL_COORDINATE_MAX };

/* Draws it through a window. */
static void draw(const struct any_shape *shape, const struct pel_rect *window)
{
    hits_open(&hits, window);
    any_draw(&hits.surface, shape, &hits.paint);
}

/* A window of SIDE x SIDE pixels, not far from a line through the middle. */
static struct pel_rect any_small_window(uint64_t i)
{
    struct random r = {i};
    const int32_t x = random_between(&r, -32768, 32767 - SIDE);
    const int32_t y = pel_max(-32768, pel_min(32767 - SIDE, x + 3));
    return (struct pel_rect){x, y, x + SIDE, y + SIDE};
}

#define CROSSED                                            \
    .kind = ANY_POLYGON, .n = 6,                           \
    .v = {{low, low},  {high, high - 7}, {-8000000, high}, \
          {high, low}, {low, 1000000},   {7000000, 3000000}}

/* Shapes as large as the range. Of each row at most so many runs are handed on,
 * in no more batches. */
TEST(huge_shapes)
{
    static const struct {
        uint64_t runs;
        struct any_shape shape;
    } rows[] = {
        {1,
         {.kind = ANY_TRIANGLE,
          .v = {{low, low}, {high, high - 5}, {low + 9000, high}}}},
        {1,
         {.kind = ANY_TRIANGLE,
          .v = {{low, low + 1}, {high, high - 700}, {high - 300, high}}}},
        {1, {.kind = ANY_CIRCLE, .radius = high - 255}},
        {1, {.kind = ANY_LINE, .v = {{low, low}, {high, high}}}},
        {1, {.kind = ANY_LINE, .v = {{high, high}, {low + 512, high}}}},
        {1, {.kind = ANY_LINE, .v = {{low + 512, high}, {high, low + 99999}}}},
        {1, {.kind = ANY_RECTANGLE, .v = {{low, low}, {high, high}}}},
        {3, {CROSSED, .rule = PEL_EVEN_ODD}},
        {3, {CROSSED, .rule = PEL_NON_ZERO}}};
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        struct any_shape s = rows[k].shape;
        const uint64_t most = rows[k].runs * SIDE;
        alarm(TOO_LONG);
        for (uint64_t i = 0; i < cases_scaled(TIMES); i++) {
            const struct pel_rect window = any_small_window(i);
            if (s.kind == ANY_CIRCLE) /* shows one side, both or none */
                s.v[0] =
                    (struct pel_point){(int32_t)(i * 77777 % 16777216) + low,
                                       (int32_t)(i * 55555 % 16777216) + low};
            draw(&s, &window);
            if (hits.runs > most || hits.pixels > SIDE * SIDE ||
                hits.batches > most)
                fail_msg("%s: %d batches, %d runs, %d pixels", any_name(&s),
                         (int)hits.batches, (int)hits.runs, (int)hits.pixels);
        }
        alarm(0);
    }
}

/* More runs in one line than a batch holds, and in the next one again. */
TEST(batches_of_one_line)
{
    enum { TEETH_SHOWN = 300, N = 4 * TEETH_SHOWN };
    const struct pel_rect b = {0, 0, 2 * TEETH_SHOWN, 2};
    static struct pel_point v[N];
    static uint32_t scratch[PEL_POLYGON_SCRATCH_SIZE(N) / 4];
    const struct pel_polygon_shape p = {v, N, PEL_EVEN_ODD};
    const uint64_t a_line = batches_of(TEETH_SHOWN, PEL_COLLECT_ROWS);
    for (int32_t i = 0; i < N; i++)
        v[i] = (struct pel_point){PEL_PX(i / 2),
                                  (i + 1) / 2 % 2 ? PEL_PX(-9) : PEL_PX(12)};
    hits_open(&hits, &b);
    assert_int_equal(
        pel_polygon(&hits.surface, &p, &hits.paint, scratch, sizeof scratch),
        PEL_OK);
    assert_int_equal(hits.runs, 2 * TEETH_SHOWN);
    assert_int_equal(hits.batches, 2 * a_line);
}

/* Batches are filled before they are handed on. */
TEST(batches)
{
    enum { ROWS = 150 };
    const struct pel_rect b = {0, 0, 3, ROWS}, small = {0, 0, SIDE, SIDE};
    static const struct {
        int32_t rows; /* of a batch */
        struct any_shape shape;
    } rows[] = {
        {PEL_BATCH_ROWS,
         {.kind = ANY_TRIANGLE,
          .v = {PEL_AT(0, 0), PEL_AT(3, 0), PEL_AT(0, 150)}}},
        {PEL_BATCH_ROWS,
         {.kind = ANY_CIRCLE, .v = {PEL_AT(1, 75)}, .radius = PEL_PX(300)}},
        {PEL_BATCH_ROWS,
         {.kind = ANY_LINE, .v = {PEL_AT(0, 0), PEL_AT(0, 150)}}},
        {PEL_COLLECT_ROWS,
         {.kind = ANY_RECTANGLE, .v = {PEL_AT(0, 0), PEL_AT(3, 150)}}},
        {PEL_COLLECT_ROWS,
         {.kind = ANY_POLYGON,
          .v = {PEL_AT(0, 0), PEL_AT(3, 0), PEL_AT(3, 150), PEL_AT(0, 150)},
          .n = 4}}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        draw(&rows[i].shape, &b);
        assert_int_equal(hits.batches,
                         batches_of(ROWS, (uint64_t)rows[i].rows));
    }
    draw(&rows[3].shape, &small);
    assert_int_equal(hits.batches, batches_of(SIDE, PEL_COLLECT_ROWS));
    assert_int_equal(hits.pixels, 3 * SIDE);
}

/* A circle that ends just above the centres of a row does not reach for it. */
TEST(rows_of_circle)
{
    const struct pel_rect b = {0, 0, 12, 12};
    struct any_shape s = {.kind = ANY_CIRCLE, .v = {PEL_AT(5.5, 5.5)}};
    for (int i = 0; i < 2; i++) {
        s.radius = PEL_PX(3) - 1 + i;
        draw(&s, &b);
        assert_int_equal(hits.runs, 5 + 2 * i);
    }
}

/* Runs of painted pixels that a reader of the rows sees, up to `most` of them
 * in a row; `rows` counts those that have any. */
static uint64_t runs_shown(uint64_t *rows, uint64_t *most)
{
    const struct pel_rect *b = &hits.surface.bounds;
    uint64_t runs = 0;
    *rows = *most = 0;
    for (int32_t y = b->y0; y < b->y1; y++) {
        uint64_t in_row = 0;
        for (int32_t x = b->x0; x < b->x1; x++)
            in_row += hits_at(&hits, x, y) &&
                      (x == b->x0 || !hits_at(&hits, x - 1, y));
        runs += in_row;
        *rows += in_row > 0;
        *most = in_row > *most ? in_row : *most;
    }
    return runs;
}

/* A line that holes and angles cut is handed on once, without empty pieces and
 * with no run in two: at most three pieces. */
static void check_pieces(const char *name, uint64_t pieces)
{
    uint64_t rows, most;
    const uint64_t runs = runs_shown(&rows, &most);
    if (hits.runs != runs || hits.batches != rows || most != pieces)
        fail_msg("%s: %d batches for %d rows, %d runs for %d, %d in one row",
                 name, (int)hits.batches, (int)rows, (int)hits.runs, (int)runs,
                 (int)most);
}

TEST(pieces)
{
    const struct pel_rect b = {0, 0, 60, 60};
    static const int32_t turns[][3] = {/* from, to, pieces */
                                       {0x1000, 0x7000, 1}, /* a sector */
                                       {0x1000, 0x7000, 2},
                                       {0x1800, 0x1000, 3},
                                       {0x9800, 0x9000, 3}};
    for (int i = 0; i < 4; i++) {
        const struct any_shape s = {
            {PEL_AT(30, 30)},    i ? ANY_ARC : ANY_SECTOR, .radius = PEL_PX(25),
            .inner = PEL_PX(12), .from = turns[i][0],      .to = turns[i][1]};
        draw(&s, &b);
        check_pieces(any_name(&s), (uint64_t)turns[i][2]);
    }
}

/* Runs without a pixel are not handed on. */
TEST(needle)
{
    static const struct any_shape needle = {
        .kind = ANY_POLYGON,
        .v = {{300, 0}, {310, PEL_PX(4)}, {320, PEL_PX(5)}, {330, 0}},
        .n = 4};
    draw(&needle, &(struct pel_rect){0, 0, 6, 6});
    assert_int_equal(hits.batches, 0);
}

static bool in_polygon(const void *outline, int32_t x, int32_t y)
{
    return reference_polygon_at(outline, x, y);
}

/* n sides, all of which cross the window's rows: `order` says from where to
 * where in x they go, one after the other. */
static void check_zigzag(int32_t n, int32_t (*order)(int32_t i))
{
    struct pel_point *v = malloc((size_t)n * sizeof *v);
    const size_t size = pel_polygon_scratch_size(n);
    void *scratch = malloc(size);
    const struct pel_rect b = {-3, 0, 5, 8};
    assert_true(v && scratch);
    for (int32_t i = 0; i < n; i++)
        v[i] = (struct pel_point){order(i), i % 2 ? PEL_PX(8) : 0};
    const struct pel_polygon_shape p = {v, n, PEL_EVEN_ODD};
    hits_open(&hits, &b);
    alarm(TOO_LONG);
    assert_int_equal(pel_polygon(&hits.surface, &p, &hits.paint, scratch, size),
                     PEL_OK);
    alarm(0);
    hits_check(&hits, in_polygon, &p, "zigzag");
    assert_true(hits.pixels > 0);
    free(v);
    free(scratch);
}

static int32_t teeth; /* even */

static int32_t to_the_left(int32_t i)
{
    return (teeth / 2 - i) * 200;
}

static int32_t to_the_right(int32_t i)
{
    return (i - teeth / 2) * 200;
}

static int32_t anywhere(int32_t i)
{
    struct random r = {(uint64_t)i};
    return random_between(&r, -8000000, 8000000);
}

static int32_t crossing(int32_t i)
{
    return i % 2 ? (i - teeth / 2) * 200 : (teeth / 2 - i) * 200;
}

TEST(zigzags)
{
    teeth = 2 * (int32_t)cases_scaled(32000);
    check_zigzag(teeth, to_the_left);
    check_zigzag(teeth, to_the_right);
    check_zigzag(teeth, anywhere);
    check_zigzag(teeth, crossing);
}

static void count_runs(const struct pel_paint *paint,
                       const struct pel_spans *rows)
{
    (void)paint;
    hits.runs += (uint64_t)rows->n;
}

/* Of rings of 32,000 px a hundredth of a degree, every way: about 10 rows, not
 * 64,000, which would take a minute. pel_dirty looks at no more. */
TEST(narrow_angles)
{
    enum { RADIUS = 32000, MOST = 15 /* s of this process */ };
    const struct pel_rect all = {-32767, -32767, 32767, 32767};
    const struct pel_surface surface = {.bounds = all, .clip = all};
    const struct pel_paint paint = PEL_PAINT(count_runs, NULL);
    struct pel_dirty dirty;
    pel_dirty_begin(&dirty, &paint);
    const clock_t start = clock();
    for (int32_t i = 0; i < (int32_t)cases_scaled(TIMES / 2); i++) {
        const int32_t from = i * 8192 - (i & 1) - 1, to = from + 2;
        const struct pel_arc_shape arc = {PEL_AT(0, 0), PEL_PX(RADIUS - 4),
                                          PEL_PX(RADIUS), from, to};
        const struct pel_sector_shape sector = {PEL_AT(0, 0), PEL_PX(RADIUS),
                                                -1 + (i & 1) * 32768,
                                                1 + (i & 1) * 32768};
        hits.runs = 0;
        pel_arc(&surface, &arc, &dirty.paint);
        pel_sector(&surface, &sector, &dirty.paint);
        if (hits.runs < 2 || hits.runs > 40)
            fail_msg("%d runs from %d", (int)hits.runs, (int)from);
        if (clock() - start > MOST * CLOCKS_PER_SEC)
            fail_msg("%d narrow arcs take %d s", (int)i, MOST);
    }
}

/* Rows of many runs, each three pixels with one between them: what is left of
 * a run is its ends, and all of it in the first row and the last. */
TEST(outline_of_many_runs)
{
    enum { RUNS = 8000, PART = 4 };
    static struct pel_span run[RUNS], memory[PEL_OUTLINE_FILTER_SPANS(RUNS)];
    const int32_t rows = (int32_t)cases_scaled(2000);
    const struct pel_surface surface = {.clip = {0, 0, 4 * RUNS, rows}};
    const struct pel_paint paint = PEL_PAINT(count_runs, NULL);
    struct pel_outline_filter f;
    for (int32_t i = 0; i < RUNS; i++)
        run[i] = (struct pel_span){4 * i, 4 * i + 3};
    hits.runs = 0;
    alarm(TOO_LONG);
    assert_true(pel_outline_filter_begin(&f, &surface, &paint, memory,
                                         PEL_OUTLINE_FILTER_SPANS(RUNS)));
    for (int32_t y = 0; y < rows; y++) {
        for (int32_t i = 0; i < RUNS; i += PART) {
            const struct pel_spans part = {&f.surface, run + i, y, PART, 0};
            f.paint.fill(&f.paint, &part);
        }
    }
    pel_outline_filter_end(&f);
    alarm(0);
    assert_int_equal(hits.runs, (uint64_t)RUNS * (uint64_t)(2 * rows - 2));
}

/* Gradients whose cells are so narrow that a pixel has thousands; neighbours
 * are alike, in halves, or not. */
static void draw_narrow(const struct pel_format *format,
                        const struct pel_ramp *ramp, uint64_t times)
{
    static uint32_t pixels[SIDE * SIDE * 2];
    const struct pel_rings rings = {{low, 0}, 256, 0},
                           four = {{128, 128}, 4 * 256, 0};
    const struct pel_point from = {low, 0}, to = {low + 3, -1},
                           below = {low, 3};
    const struct pel_rect b = {-SIDE, 0, 0, SIDE};
    struct pel_surface s;
    struct pel_linear linear, vertical, horizontal;
    struct pel_radial radial, near_by;
    pel_surface_init(&s, format, pixels, sizeof pixels, &b);
    assert_int_equal(pel_linear_init(&linear, from, to, ramp), PEL_OK);
    assert_int_equal(pel_linear_init(&vertical, from, below, ramp), PEL_OK);
    assert_int_equal(pel_linear_init(&horizontal, from,
                                     (struct pel_point){low + 5, 0}, ramp),
                     PEL_OK);
    assert_int_equal(pel_radial_init(&radial, &rings, ramp), PEL_OK);
    assert_int_equal(pel_radial_init(&near_by, &four, ramp), PEL_OK);
    for (uint64_t i = 0; i < times; i++) {
        pel_box(&s, &b, &linear.base.paint);
        pel_box(&s, &b, &vertical.base.paint);
        pel_box(&s, &b, &horizontal.base.paint);
        pel_box(&s, &b, &radial.base.paint);
        pel_box(&s, &b, &near_by.base.paint);
    }
}

TEST(narrow_cells)
{
    enum { CELLS = 32767 };
    static pel_color colors[CELLS];
    const uint64_t times = cases_scaled(TIMES / 10);
    for (int32_t i = 0; i < CELLS; i++)
        colors[i] = PEL_RGB(i, i >> 8, 0);
    alarm(TOO_LONG);
    draw_narrow(&pel_xrgb8888, &(struct pel_ramp){colors, CELLS, PEL_REFLECT},
                times);
    for (int32_t i = 0; i < CELLS; i++)
        colors[i] = i < CELLS / 2 ? PEL_RGB(0, 0, 0) : PEL_RGB(255, 255, 255);
    draw_narrow(&pel_mono1_pages, &(struct pel_ramp){colors, CELLS, PEL_REPEAT},
                times);
    draw_narrow(&pel_mono1_pages,
                &(struct pel_ramp){colors + CELLS / 2 - 1, 2, PEL_REPEAT},
                times);
    alarm(0);
}
