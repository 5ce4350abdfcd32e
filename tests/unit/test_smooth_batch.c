/* Batches of smooth shapes in which one row is wide and the others are narrow,
 * and long rows: each is what its parts are alone. */
#include <string.h>

#include "core/pel.h"
#include "core/smooth/smooth_layer.h"
#include "tests/support/check.h"

enum { WIDTH = 600, LEFT = -280, ROWS = PEL_SMOOTH_BATCH_ROWS };

static uint16_t drawn[ROWS][WIDTH], expected[ROWS][WIDTH];
static struct pel_hatch paint;

/* Rows of 2 full pixels, but for one, between two that are covered in part;
 * each begins where the one above ends. */
static void make_batch(struct pel_smooth_batch *b, int32_t wide, int32_t full)
{
    int32_t x = LEFT + 3;
    *b = (struct pel_smooth_batch){.n = ROWS};
    for (int32_t i = 0; i < ROWS; i++) {
        b->count[2 * i] = b->count[2 * i + 1] = 1;
        b->coverage[2 * i] = 100;
        b->coverage[2 * i + 1] = 50;
        b->at.full[i].x0 = x;
        x += i == wide ? full : 2;
        b->at.full[i].x1 = x++;
    }
}

static void begin(struct pel_smooth *smooth, struct pel_surface *surface,
                  uint16_t (*pixels)[WIDTH])
{
    const struct pel_rect bounds = {LEFT, 0, LEFT + WIDTH, ROWS};
    memset(pixels, 0x3C, sizeof drawn);
    assert_int_equal(pel_surface_init(surface, &pel_rgb565_le, pixels,
                                      sizeof drawn, &bounds),
                     PEL_OK);
    assert_true(pel_smooth_begin(smooth, surface, &paint.base.paint));
}

static void draw_alone(const struct pel_smooth *smooth,
                       const struct pel_smooth_batch *b)
{
    for (int32_t i = 0; i < ROWS; i++) {
        const struct pel_span *const full = &b->at.full[i];
        const struct pel_smooth_row row = {
            i, full->x0 - 1, 1, full->x1 - full->x0, 1, &b->coverage[2 * i]};
        pel_smooth_paint(smooth, &row);
    }
}

static void make_paint(void)
{
    const struct pel_hatch_lines lines = {1, 1, 0, 7, 3};
    pel_hatch_init(&paint, &lines, PEL_RGB(250, 10, 90),
                   PEL_RGBA(5, 200, 40, 70));
}

TEST(rows_are_what_they_are_alone)
{
    make_paint();
    for (int32_t wide = 0; wide < ROWS; wide++)
        for (int32_t full = 0; full < WIDTH - 4 * ROWS; full += 3) {
            struct pel_smooth_batch b;
            struct pel_smooth smooth;
            struct pel_surface surface;
            make_batch(&b, wide, full);
            begin(&smooth, &surface, expected);
            draw_alone(&smooth, &b);
            begin(&smooth, &surface, drawn);
            pel_smooth_paint_batch(&smooth, &b);
            assert_memory_equal(drawn, expected, sizeof drawn);
        }
}

TEST(no_rows_paint_nothing)
{
    struct pel_smooth_batch b;
    struct pel_smooth smooth;
    struct pel_surface surface;
    make_paint();
    make_batch(&b, 0, 9);
    b.n = 0;
    begin(&smooth, &surface, expected);
    begin(&smooth, &surface, drawn);
    pel_smooth_paint_batch(&smooth, &b);
    assert_memory_equal(drawn, expected, sizeof drawn);
}

/* Pixel by pixel. */
static void draw_pixels(const struct pel_smooth *smooth,
                        const struct pel_smooth_row *row)
{
    struct pel_smooth_row one = *row;
    const int32_t behind = row->left + row->full, n = behind + row->right;
    for (int32_t i = 0; i < n; i++, one.x++) {
        one.full = i >= row->left && i < behind;
        one.left = !one.full;
        one.right = 0;
        pel_smooth_paint(smooth, &one);
        one.coverage += one.left;
    }
}

TEST(rows_are_their_pixels)
{
    static const int32_t sizes[] = {0, 8, 41, 48, 49, 50, 121, 124, 129, 255};
    uint8_t coverage[510];
    make_paint();
    for (int i = 0; i < 510; i++)
        coverage[i] = (uint8_t)(i * 7);
    for (int i = 0; i < 10 * 10 * 3; i++) {
        const struct pel_smooth_row row = {
            0,           LEFT + 1,           sizes[i % 10],
            i / 100 + 7, sizes[i / 10 % 10], coverage};
        struct pel_smooth smooth;
        struct pel_surface surface;
        begin(&smooth, &surface, expected);
        draw_pixels(&smooth, &row);
        begin(&smooth, &surface, drawn);
        pel_smooth_paint(&smooth, &row);
        assert_memory_equal(drawn, expected, sizeof drawn);
    }
}

#if !PEL_SMOOTH_TINY

/* Pixel i has the first color k for which, in parts of a unit of 7,
 * (7 error + remainder) + 7 step i - (7 cell + cell_remainder) k < 0. */
TEST(a_walk_keeps_its_remainder)
{
    for (int32_t n = 1; n < 40; n++) {
        pel_color row[41] = {0};
        const struct pel_surface s = {
            row, 160, {0, 0, 40, 1}, {0, 0, 40, 1}, &pel_smooth_colors};
        const struct pel_walk walk = {
            .mix = {.high = 0xFF000000, .low_change = 256},
            .error = -4,
            .remainder = 0,
            .cell = 5,
            .cell_remainder = n % 7,
            .unit = 7,
            .step = 4};
        assert_true(pel_smooth_colors.channels->walk(&s, 0, 0, n, &walk));
        for (int32_t i = 0, k = 0; i < n; i++) {
            while (-28 + 28 * i - (35 + n % 7) * k >= 0)
                k++;
            assert_int_equal(row[i], PEL_RGB(0, 0, k));
        }
        assert_int_equal(row[n], 0);
    }
}

#endif
