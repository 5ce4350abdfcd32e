/* A paint that a program brings itself: it is handed rows of every shape, in
 * absolute coordinates. */
#include "core/hit/hit.h"
#include "tests/support/any_shape.h"
#include "tests/support/canvas.h"
#include "tests/support/check.h"
#include "tests/support/shapes.h"

/* A color that names its pixel. */
static pel_color color_at(const void *paint, int32_t x, int32_t y)
{
    (void)paint;
    return PEL_RGBA(x * 37 & 255, y * 59 & 255, (x ^ y) * 5 & 255,
                    (x + 2 * y) * 16 & 255);
}

static void fill_named(const struct pel_paint *paint,
                       const struct pel_spans *rows)
{
    for (int32_t i = 0; i < rows->n; i++) {
        const int32_t y = rows->y + i * rows->step, x1 = rows->span[i].x1;
        for (int32_t x = rows->span[i].x0, n; x < x1; x += n) {
            pel_color colors[PEL_BUFFER_PIXELS];
            for (n = 0; n < PEL_BUFFER_PIXELS && x + n < x1; n++)
                colors[n] = color_at(paint, x + n, y);
            pel_put_colors(rows->surface, x, y, n, colors);
        }
    }
}

static const struct pel_paint named = {.fill = fill_named};

TEST(every_shape_in_every_format)
{
    static struct canvas canvas;
    static struct hits hits;
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        struct random *r = &c.random;
        struct any_shape s;
        const struct pel_rect b = shape_bounds(r, 40, 24);
        any_in_box(r, &s, (enum any_kind)(c.next % ANY_KINDS), &b);
        canvas_open(&canvas, layouts[random_word(r) % LAYOUT_COUNT].format, &b,
                    random_word(r) % CANVAS_STYLES);
        hits_open(&hits, &b);
        any_draw(&canvas.surface, &s, &named);
        any_draw(&hits.surface, &s, &hits.paint);
        canvas_check_drawn(&canvas, &hits, color_at, NULL);
    }
}

/* A format of one's own that counts how often each pixel is written: rows are
 * no copies of each other. */
static void count_spans(const struct pel_spans *spans, uint32_t pixel)
{
    (void)pixel;
    for (int32_t i = 0; i < spans->n; i++) {
        const struct pel_surface *s = spans->surface;
        uint32_t *row =
            (uint32_t *)(void *)pel_surface_line(s, spans->y + i * spans->step);
        for (int32_t x = spans->span[i].x0; x < spans->span[i].x1; x++)
            row[x - s->bounds.x0]++;
    }
}

static uint32_t pack_nothing(pel_color color)
{
    (void)color;
    return 0;
}

TEST(fills_of_own_formats_are_called)
{
    static const struct pel_format counting = {.id = 128,
                                               .bits = 32,
                                               .word = 4,
                                               .pack = pack_nothing,
                                               .fill = count_spans};
    static const struct pel_flat paint = PEL_FLAT(PEL_RGB(0, 0, 0));
    static const pel_color black = PEL_RGB(0, 0, 0);
    static const struct pel_ramp ramp = {&black, 1, PEL_PAD};
    static const struct pel_point v[3] = {PEL_AT(1, 1), PEL_AT(15, 2),
                                          PEL_AT(3, 14)};
    const struct pel_rect bounds = {0, 0, 16, 16};
    uint32_t counts[16 * 16] = {0};
    struct pel_surface s;
    struct pel_linear upright;
    pel_surface_init(&s, &counting, counts, sizeof counts, &bounds);
    pel_triangle(&s, v, &paint.paint);
    pel_linear_init(&upright, v[0], (struct pel_point){0, v[0].y}, &ramp);
    pel_box(&s, &bounds, &upright.base.paint);
    for (int32_t i = 0; i < 256; i++)
        assert_int_equal(counts[i], 1 + pel_hit_triangle(v, i % 16, i / 16));
}
