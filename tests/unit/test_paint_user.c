/* A paint that a program brings itself: it is handed rows of every shape, in
 * absolute coordinates, and may take whole triangles. */

#include "core/hit/hit.h"
#include "tests/support/canvas.h"
#include "tests/support/check.h"
#include "tests/support/items.h"

/* A color that names its pixel. */
static pel_color color_at(int32_t x, int32_t y)
{
    return PEL_RGBA(x * 37 & 255, y * 59 & 255, (x ^ y) * 5 & 255,
                    (x + 2 * y) * 16 & 255);
}

static void fill_named(const struct pel_paint *paint,
                       const struct pel_spans *rows)
{
    (void)paint;
    for (int32_t i = 0; i < rows->n; i++) {
        const int32_t y = rows->y + i * rows->step, x1 = rows->span[i].x1;
        for (int32_t x = rows->span[i].x0, n; x < x1; x += n) {
            pel_color colors[PEL_BUFFER_PIXELS];
            for (n = 0; n < PEL_BUFFER_PIXELS && x + n < x1; n++)
                colors[n] = color_at(x + n, y);
            pel_put_colors(rows->surface, x, y, n, colors);
        }
    }
}

static const struct pel_paint named = {.fill = fill_named};

static pel_color color_of(const void *paint, int32_t x, int32_t y)
{
    (void)paint;
    return color_at(x, y);
}

static void check_item(const struct layout *l, const struct item *item,
                       const struct pel_rect *b, unsigned style)
{
    static struct canvas canvas;
    static struct hits hits;
    canvas_open(&canvas, l->format, b, style);
    hits_open(&hits, b);
    item_cover(&canvas.surface, item, &named);
    item_cover(&hits.surface, item, &hits.paint);
    canvas_check_drawn(&canvas, &hits, color_of, NULL);
}

static void test_every_shape_in_every_format(void **state)
{
    (void)state;
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        struct random *r = &c.random;
        struct item item;
        struct pel_rect b = {random_between(r, -80, 80) & ~7,
                             random_between(r, -80, 80) & ~7, 0, 0};
        b.x1 = b.x0 + random_between(r, 1, 40);
        b.y1 = b.y0 + random_between(r, 1, 24);
        item_random(r, &item, &b, false);
        check_item(&layouts[random_word(r) % LAYOUT_COUNT], &item, &b,
                   random_word(r) % CANVAS_STYLES);
    }
}

#if PEL_FAST_FILLS

struct counting {
    struct pel_paint paint;
    bool takes;
    int fast, rows;
};

static void count_rows(const struct pel_paint *paint,
                       const struct pel_spans *rows)
{
    ((struct counting *)(uintptr_t)paint)->rows += rows->n;
}

static bool count_fast(const struct pel_paint *paint,
                       const struct pel_surface *surface,
                       const struct pel_fast_triangle *triangle)
{
    struct counting *c = (struct counting *)(uintptr_t)paint;
    (void)surface;
    (void)triangle;
    c->fast++;
    return c->takes;
}

/* `fast` is asked once, where nothing is clipped; what it leaves comes as rows.
 */
static void test_fast_is_asked_first(void **state)
{
    static const struct pel_point inside[3] = {PEL_AT(0, 0), PEL_AT(8, 0),
                                               PEL_AT(0, 8)};
    static const struct pel_point clipped[3] = {
        PEL_AT(0, 0), {2049, 0}, PEL_AT(0, 8)};
    static const struct pel_point empty[3] = {
        {129, 129}, {300, 129}, {200, 380}};
    static const struct {
        const struct pel_point *v;
        bool takes;
        int fast, rows;
    } row[] = {{inside, true, 1, 0},
               {inside, false, 1, 8},
               {clipped, true, 0, 8},
               {empty, true, 0, 0}};
    static uint8_t pixels[64];
    struct pel_surface s;
    (void)state;
    s = surface_of(&pel_gray8, pixels, sizeof pixels, 8, 8);
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct counting c = {{count_rows, count_fast}, row[i].takes, 0, 0};
        pel_triangle(&s, row[i].v, &c.paint);
        if (c.fast != row[i].fast || c.rows != row[i].rows)
            fail_msg("row %zu: %d times fast, %d rows", i, c.fast, c.rows);
    }
}

#endif

/* A format of one's own that counts how often each pixel is written. */
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

static void test_fills_of_own_formats_are_called(void **state)
{
    static const struct pel_format counting = {.id = 128,
                                               .bits = 32,
                                               .word = 4,
                                               .pack = pack_nothing,
                                               .fill = count_spans};
    static const struct pel_flat paint = PEL_FLAT(PEL_RGB(0, 0, 0));
    static const struct pel_point v[3] = {PEL_AT(1, 1), PEL_AT(15, 2),
                                          PEL_AT(3, 14)};
    const struct pel_rect bounds = {0, 0, 16, 16};
    uint32_t counts[16 * 16] = {0};
    struct pel_surface s;
    (void)state;
    pel_surface_init(&s, &counting, counts, sizeof counts, &bounds);
    pel_triangle(&s, v, &paint.paint);
    for (int32_t i = 0; i < 256; i++)
        assert_int_equal(counts[i], pel_hit_triangle(v, i % 16, i / 16));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_shape_in_every_format),
        cmocka_unit_test(test_fills_of_own_formats_are_called),
#if PEL_FAST_FILLS
        cmocka_unit_test(test_fast_is_asked_first),
#endif
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
