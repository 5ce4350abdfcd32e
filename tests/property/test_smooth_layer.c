/* The layer below smooth shapes: a row of coverage shows what a mask of the
 * same grey shows, in any paint and format; full runs what the paint itself
 * does; nothing else changes. */
#include <string.h>

#include "core/smooth/smooth.h"
#include "tests/support/any_paint.h"
#include "tests/support/canvas.h"
#include "tests/support/check.h"
#include "tests/support/shapes.h"

enum { SIDE = 80 };

static struct canvas drawn, expected, dithered;
static uint8_t grey[SIDE * SIDE];
static const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));

/* One color in every other pixel of every other row: the other pixels are not
 * painted. */
static void odd_pixels_fill(const struct pel_paint *paint,
                            const struct pel_spans *spans)
{
    struct pel_span one;
    struct pel_spans pixel = {spans->surface, &one, spans->y, 1, 0};
    for (int32_t i = 0; i < spans->n; i++, pixel.y += spans->step)
        for (int32_t x = spans->span[i].x0; x < spans->span[i].x1; x++) {
            one = (struct pel_span){x, x + 1};
            if (x & pixel.y & 1)
                pel_flat_fill(paint, &pixel);
        }
}

static union any_paint made;
static pel_color colors[16];

static void make_gradient(struct random *r)
{
    static const struct pel_ramp ramp = {colors, 3, PEL_REFLECT};
    const struct pel_point from = {random_between(r, 0, 9999), PEL_PX(5)},
                           to = {PEL_PX(9), random_between(r, 0, 9999)};
    const struct pel_point below = {from.x, 19999 - to.y};
    const struct pel_point left = {PEL_PX(-100), from.x}, right = {39700, to.y};
    const struct pel_ramp mixed = {colors, 2, (enum pel_spread)(from.x % 3)};
    const struct pel_rings rings = {to, 256 + from.x, 77};
    switch (random_word(r) % 5) {
    case 0:
        pel_linear_init(&made.linear, from, to, &ramp);
        break;
    case 1:
        pel_conic_init(&made.conic, from, 9, &ramp);
        break;
    case 2: /* cells of a pixel */
        pel_linear_init(&made.linear, left, right, &mixed);
        break;
    case 3:
        pel_linear_init(&made.linear, from, below, &mixed);
        break;
    default:
        pel_radial_init(&made.radial, &rings, &mixed);
    }
}

/* Of an opaque color at every pixel, or of any alpha. */
static const struct pel_paint *make_paint(struct random *r, bool opaque)
{
    static const struct pel_point corners[3] = {PEL_AT(60, 5), PEL_AT(40, 70),
                                                PEL_AT(5, 9)};
    static struct pel_fan_triangle memory[3];
    static const struct pel_texels texels = {NULL, colors, 4, 4, false};
    static const struct pel_texture_map map = PEL_TEXTURE_AT(3, 4);
    static const struct pel_checker_fields fields = {3, 2, 1, 0};
    static const struct pel_hatch_lines lines = {1, -1, 2, 5, 2};
    for (int i = 0; i < 16; i++)
        colors[i] = random_word(r) | (opaque ? PEL_RGB(0, 0, 0) : 0);
    const struct pel_fan_points fan = {PEL_AT(35, 30), colors[3], corners,
                                       colors, 3};
    made.flat = (struct pel_flat)PEL_FLAT(colors[0]);
    switch (random_word(r) % 11) {
    case 0:
        pel_texture_init_nearest(&made.texture, &texels, &map);
        break;
    case 1:
        pel_texture_init_bilinear(&made.texture, &texels, &map);
        break;
    case 2:
        pel_checker_init(&made.checker, &fields, colors[0], colors[1]);
        break;
    case 3:
        pel_hatch_init(&made.hatch, &lines, colors[0], colors[1]);
        break;
    case 4:
        pel_fan_init(&made.fan, &fan, memory);
        break;
    case 5:
    case 6:
        if (!opaque && random_word(r) % 2)
            made.flat.paint.fill = odd_pixels_fill;
        break;
    default:
        make_gradient(r);
    }
    return &made.paint;
}

static uint8_t random_coverage(struct random *r)
{
    const uint32_t kind = random_word(r) % 8;
    return kind == 0 ? 0 : kind == 1 ? 255 : (uint8_t)random_word(r);
}

/* Writes a part of a row into the mask. */
static void mask_row(int32_t x, int32_t y, int32_t n, const uint8_t *coverage)
{
    const struct pel_rect *const all = &drawn.surface.bounds;
    for (int32_t i = 0; i < n; i++)
        if (x + i >= all->x0 && x + i < all->x1)
            grey[(y - all->y0) * SIDE + x + i - all->x0] =
                coverage ? coverage[i] : 255;
}

/* Rows of random parts, the same into the layer and into the mask. */
static void draw_rows(struct random *r, const struct pel_smooth *smooth)
{
    const struct pel_rect clip = drawn.surface.clip;
    uint8_t bytes[SIDE];
    for (int32_t y = clip.y0; y < clip.y1; y++) {
        const int32_t n = pel_max(clip.x1 - clip.x0, 0);
        const int32_t x = random_between(r, 0, n);
        const int32_t left = random_between(r, 0, n - x) / (1 + (y & 3));
        const int32_t full = random_between(r, 0, n - x - left);
        const int32_t right = random_between(r, 0, n - x - left - full);
        const struct pel_smooth_row row = {y,    clip.x0 + x, left,
                                           full, right,       bytes};
        for (int32_t i = 0; i < SIDE; i++)
            bytes[i] = random_coverage(r);
        mask_row(row.x, y, left, bytes);
        mask_row(row.x + left, y, full, NULL);
        mask_row(row.x + left + full, y, right, bytes + left);
        pel_smooth_paint(smooth, &row);
    }
}

/* Paints a batch whose first row is y, or its last one; what is there then must
 * be as it was. */
static void paint_batch(const struct pel_smooth *smooth,
                        struct pel_smooth_batch *b, bool upwards)
{
#if PEL_SMOOTH_TINY
    assert_true(b->n == 1);
    (void)upwards;
#else
    const struct pel_smooth_batch before = *b;
    if (upwards) {
        pel_smooth_paint_upwards(smooth, b, b->y + b->n - 1);
        assert_memory_equal(b, &before, sizeof before);
        return;
    }
#endif
    pel_smooth_paint_batch(smooth, b);
}

/* Fills a batch of n rows from y on, some of them outside of the clip's
 * columns, and paints what is inside. */
static void draw_batch(struct random *r, const struct pel_smooth *smooth,
                       int32_t y, int32_t n)
{
    const bool upwards = random_word(r) % 2, follows = random_word(r) % 4;
    const struct pel_rect *const all = &drawn.surface.bounds;
    struct pel_smooth_batch b = {.y = y, .n = n};
    uint8_t *coverage = b.coverage;
    const int32_t full = random_word(r) % 2 ? 30 : 8;
    for (int32_t i = 0; i < n; i++) {
        const int32_t row = upwards ? y + n - 1 - i : y + i;
        const int32_t most = PEL_SMOOTH_BATCH_BYTES / 2 / n;
        int32_t *const x = b.at.x + 2 * i;
        uint8_t *const count = b.count + 2 * i;
        count[0] = (uint8_t)random_between(r, 0, most);
        count[1] = (uint8_t)random_between(r, 0, most);
        x[0] = random_between(r, all->x0 - 9, all->x1 + 9);
        if (i > 0 && follows)
            x[0] = x[-2] + random_between(r, -5, 5);
        x[1] = x[0] + pel_max(0, random_between(r, -9, full));
        for (int32_t k = 0; k < count[0] + count[1]; k++)
            coverage[k] = random_coverage(r);
        mask_row(x[0] - count[0], row, count[0], coverage);
        mask_row(x[0], row, x[1] - x[0], NULL);
        mask_row(x[1], row, count[1], coverage + count[0]);
        coverage += count[0] + count[1];
    }
    pel_smooth_clip_batch(&b, &drawn.surface.clip);
    paint_batch(smooth, &b, upwards);
}

static void draw_batches(struct random *r, const struct pel_smooth *smooth)
{
    const struct pel_rect *const clip = &drawn.surface.clip;
    for (int32_t y = clip->y0, n; y < clip->y1; y += n) {
        n = pel_min(random_between(r, 1, PEL_SMOOTH_BATCH_ROWS), clip->y1 - y);
        draw_batch(r, smooth, y, n);
    }
}

TEST(rows_are_a_mask)
{
    const struct pel_surface mask =
        surface_of(&pel_gray8, grey, sizeof grey, SIDE, SIDE);
    for (struct cases c = cases_of(60000); cases_next(&c);) {
        struct random *r = &c.random;
        const struct pel_paint *const paint = make_paint(r, random_word(r) % 2);
        const struct pel_format *const format =
            layouts[random_word(r) % LAYOUT_COUNT].format;
        const struct pel_rect bounds = shape_bounds(r, SIDE, 9);
        const unsigned style = random_word(r) % CANVAS_STYLES;
        const struct pel_rect clip = shape_clip(r, &bounds);
        struct pel_masked masked;
        struct pel_smooth smooth;
        canvas_open(&drawn, format, &bounds, style);
        canvas_open(&expected, format, &bounds, style);
        pel_surface_clip(&drawn.surface, &clip);
        pel_surface_clip(&expected.surface, &clip);
        memset(grey, 0, sizeof grey);
        assert_true(pel_smooth_begin(&smooth, &drawn.surface, paint));
        if (random_word(r) % 2)
            draw_rows(r, &smooth);
        else
            draw_batches(r, &smooth);
        assert_int_equal(
            pel_masked_init(&masked, &mask, bounds.x0, bounds.y0, paint),
            PEL_OK);
        pel_box(&expected.surface, &bounds, &masked.base.paint);
        canvas_check_same(&expected, &drawn);
        canvas_check(&drawn);
    }
}

/* Paints the pixels of the mask one by one. */
static void draw_pixels(const struct pel_smooth *smooth)
{
    const struct pel_rect *const b = &expected.surface.bounds;
    const struct pel_rect *const clip = &expected.surface.clip;
    for (int32_t y = clip->y0; y < clip->y1; y++)
        for (int32_t x = clip->x0; x < clip->x1; x++) {
            const uint8_t *const a = &grey[(y - b->y0) * SIDE + x - b->x0];
            const int32_t full = *a == 255;
            const struct pel_smooth_row row = {y, x, !full, full, 0, a};
            pel_smooth_paint(smooth, &row);
        }
}

/* In paints that look at the surface, of which a mask is no source; and only
 * pixels that are covered at all are asked for. */
TEST(rows_are_their_pixels)
{
    for (struct cases c = cases_of(15000); cases_next(&c);) {
        struct random *r = &c.random;
        const struct pel_paint *const source =
            make_paint(r, random_word(r) % 2);
        const struct pel_format *const format =
            layouts[random_word(r) % LAYOUT_COUNT].format;
        const struct pel_rect bounds = shape_bounds(r, SIDE, 9);
        const unsigned style = random_word(r) % CANVAS_STYLES;
        const struct pel_rect clip = shape_clip(r, &bounds);
        struct pel_dither dither;
        struct pel_blend blend;
        struct pel_smooth smooth;
        struct pel_dirty dirty;
        struct pel_surface mask;
        pel_dither_init(&dither, source);
        pel_blend_init(&blend, source,
                       (enum pel_blend_mode)(random_word(r) % 3));
        canvas_open(&drawn, format, &bounds, style);
        canvas_open(&expected, format, &bounds, style);
        pel_surface_clip(&drawn.surface, &clip);
        pel_surface_clip(&expected.surface, &clip);
        memset(grey, 0, sizeof grey);
        const struct pel_paint *const paint =
            random_word(r) % 2 ? &dither.paint : &blend.paint;
        pel_dirty_begin(&dirty, paint);
        assert_true(pel_smooth_begin(&smooth, &drawn.surface, &dirty.paint));
        draw_batches(r, &smooth);
        pel_surface_init_rect(&mask, &pel_gray8, grey, SIDE, &bounds);
        pel_surface_clip(&mask, &clip);
        const struct pel_rect box = shape_box(&mask);
        assert_memory_equal(&dirty.box, &box, sizeof box);
        assert_true(pel_smooth_begin(&smooth, &expected.surface, paint));
        draw_pixels(&smooth);
        canvas_check_same(&expected, &drawn);
        canvas_check(&drawn);
    }
}

static void draw_any(const struct pel_surface *surface, uint32_t kind,
                     const struct pel_point v[4], const struct pel_paint *paint)
{
    static uint64_t scratch[PEL_SMOOTH_POLYGON_SCRATCH_SIZE(4, SIDE) / 8 + 1];
    const struct pel_polygon_shape polygon = {v, 4, PEL_EVEN_ODD};
    const struct pel_thick_line_shape line = {v[0], v[1], 700};
    if (kind == 0)
        pel_smooth_triangle(surface, v, paint);
    else if (kind == 1)
        pel_smooth_rectangle(surface, v[0], v[1], paint);
    else if (kind == 2)
        pel_smooth_thick_line(surface, &line, paint);
    else
        assert_int_equal(pel_smooth_polygon(surface, &polygon, paint, scratch,
                                            sizeof scratch),
                         PEL_OK);
}

/* With a format and without: the box of what is covered at all. */
TEST(dirty_boxes_hold_the_fringe)
{
    for (struct cases c = cases_of(40000); cases_next(&c);) {
        struct random *r = &c.random;
        struct pel_dirty dirty[2];
        struct pel_point v[4];
        const uint32_t kind = random_word(r) % 4;
        const struct pel_rect bounds = shape_bounds(r, SIDE, SIDE);
        const struct pel_surface measure = {NULL, 0, bounds, bounds, NULL};
        struct pel_surface gray;
        shape_in_box(r, v, 4, &bounds);
        memset(grey, 0, sizeof grey);
        assert_int_equal(
            pel_surface_init(&gray, &pel_gray8, grey, sizeof grey, &bounds),
            PEL_OK);
        pel_dirty_begin(&dirty[0], &white.paint);
        pel_dirty_begin(&dirty[1], NULL);
        draw_any(&gray, kind, v, &dirty[0].paint);
        draw_any(&measure, kind, v, &dirty[1].paint);
        const struct pel_rect box = shape_box(&gray);
        for (int i = 0; i < 2; i++)
            assert_memory_equal(&dirty[i].box, &box, sizeof box);
    }
}

/* The color that a pixel of a paint has where it is not dithered. */
static pel_color color_at(const struct pel_paint *paint, int32_t x, int32_t y)
{
    const struct pel_rect pixel = {x, y, x + 1, y + 1};
    uint32_t memory[1] = {0};
    struct pel_surface one;
    pel_color color;
    pel_surface_init(&one, &pel_xrgb8888, memory, sizeof memory, &pixel);
    pel_box(&one, &pixel, paint);
    pel_xrgb8888.load(&one, x, y, 1, &color);
    return color;
}

/* The dithered color of each pixel is what is weighed. */
TEST(dither_comes_before_coverage)
{
    for (struct cases c = cases_of(10000); cases_next(&c);) {
        struct random *r = &c.random;
        const struct pel_paint *const source = make_paint(r, true);
        const struct pel_format *const format =
            layouts[random_word(r) % LAYOUT_COUNT].format;
        const struct pel_rect b = shape_bounds(r, SIDE, 9);
        struct pel_dither dither;
        struct pel_point v[4];
        struct pel_surface gray;
        shape_in_box(r, v, 4, &b);
        memset(grey, 0, sizeof grey);
        pel_surface_init(&gray, &pel_gray8, grey, sizeof grey, &b);
        canvas_open(&drawn, format, &b, 0);
        canvas_open(&expected, format, &b, 0);
        canvas_open(&dithered, format, &b, 0);
        pel_dither_init(&dither, source);
        pel_box(&dithered.surface, &b, &dither.paint);
        pel_smooth_triangle(&gray, v, &white.paint);
        pel_smooth_triangle(&drawn.surface, v, &dither.paint);
        for (int32_t y = b.y0; y < b.y1; y++)
            for (int32_t x = b.x0; x < b.x1; x++) {
                const uint32_t a = pel_surface_line(&gray, y)[x - b.x0];
                pel_color color;
                format->load(&dithered.surface, x, y, 1, &color);
                if (a > 0 && format->depth[0] == 0)
                    color = color_at(source, x, y);
                color = (color & 0xFFFFFF) | a << 24;
                format->put(&expected.surface, x, y, 1, &color);
            }
        canvas_check_same(&expected, &drawn);
    }
}
