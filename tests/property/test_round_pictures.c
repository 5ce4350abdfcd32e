/* Every shape and outline in every format, opaque and with alpha: each pixel of
 * the shape is the colour, mixed once by the rule, no other byte changes, and
 * tiles give the same bytes as the whole. Fenced canvases. */
#include "tests/support/any_shape.h"
#include "tests/support/canvas.h"
#include "tests/support/check.h"
#include "tests/support/shapes.h"

enum { SIZE = 40 };

static struct canvas whole, tile;

/* A case: a shape or its outline in one colour. */
struct drawing {
    struct any_shape shape;
    bool outline;
    struct pel_flat flat;
};

static void draw(const struct canvas *c, const struct drawing *d)
{
    if (d->outline)
        any_draw_outline(&c->surface, &d->shape, &d->flat.paint);
    else
        any_draw(&c->surface, &d->shape, &d->flat.paint);
}

static bool is_covered(const struct drawing *d, int32_t x, int32_t y)
{
    return d->outline ? any_reference_outline_at(&d->shape, x, y)
                      : any_reference_at(&d->shape, x, y);
}

static pel_color random_color(struct random *r)
{
    static const uint8_t alpha[] = {255, 255, 0, 1, 128, 254};
    uint32_t color = random_word(r), which = random_word(r) % 8;
    if (which < sizeof alpha)
        color = (color & UINT32_C(0xFFFFFF)) | (uint32_t)alpha[which] << 24;
    return color;
}

static struct drawing open_case(struct random *r)
{
    const struct pel_format *f = layouts[random_word(r) % LAYOUT_COUNT].format;
    const struct pel_flat flat = PEL_FLAT(random_color(r));
    struct pel_rect b = {random_between(r, -40, 40) & ~7,
                         random_between(r, -40, 40) & ~7, 0, 0};
    struct drawing d;
    b.x1 = b.x0 + random_between(r, 1, SIZE);
    b.y1 = b.y0 + random_between(r, 1, SIZE);
    canvas_open(&whole, f, &b, random_word(r) % CANVAS_STYLES);
    d.flat = flat;
    any_in_box(r, &d.shape, (enum any_kind)(random_word(r) % ANY_KINDS), &b);
    d.outline = random_word(r) & 1;
    return d;
}

static void test_bytes_follow_the_rule(void)
{
    uint64_t covered = 0;
    for (struct cases c = cases_of(60000); cases_next(&c);) {
        const struct drawing d = open_case(&c.random);
        const struct pel_rect *b = &whole.surface.bounds;
        draw(&whole, &d);
        canvas_check(&whole);
        for (int32_t y = b->y0; y < b->y1; y++)
            for (int32_t x = b->x0; x < b->x1; x++) {
                uint32_t want = canvas_pixel_before(&whole, x, y);
                if (is_covered(&d, x, y)) {
                    want = layout_over(whole.layout, want, d.flat.color);
                    covered++;
                }
                if (canvas_pixel(&whole, x, y) != want)
                    fail_msg("%s, %s, colour %08x: pixel %d, %d: expected %x, "
                             "got %x; %s",
                             whole.layout->name, any_name(&d.shape),
                             d.flat.color, x, y, want,
                             canvas_pixel(&whole, x, y), cases_replay());
            }
    }
    print_message("%llu pixels covered\n", (unsigned long long)covered);
}

static void check_tile(const struct drawing *d, const struct pel_rect *t)
{
    canvas_open(&tile, whole.layout->format, t, 0);
    draw(&tile, d);
    canvas_check(&tile);
    for (int32_t y = t->y0; y < t->y1; y++)
        for (int32_t x = t->x0; x < t->x1; x++)
            if (canvas_pixel(&tile, x, y) != canvas_pixel(&whole, x, y))
                fail_msg("%s, %s: pixel %d, %d: whole %x, tile %x; %s",
                         whole.layout->name, any_name(&d->shape), x, y,
                         canvas_pixel(&whole, x, y), canvas_pixel(&tile, x, y),
                         cases_replay());
}

static void test_tiles_equal_the_whole(void)
{
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        const struct drawing d = open_case(&c.random);
        const struct pel_rect b = whole.surface.bounds;
        const int32_t step = whole.layout->bits < 8 ? 8 : 5;
        const int32_t width =
            step * (int32_t)(1 + random_word(&c.random) % 4 * 4);
        struct pel_rect t;
        draw(&whole, &d);
        for (t.y0 = b.y0; t.y0 < b.y1; t.y0 = t.y1) {
            t.y1 = pel_min(t.y0 + step, b.y1);
            for (t.x0 = b.x0; t.x0 < b.x1; t.x0 = t.x1) {
                t.x1 = pel_min(t.x0 + width, b.x1);
                check_tile(&d, &t);
            }
        }
    }
}

/* Clips with no pixel, far away or turned round: nothing is drawn. */
static void test_empty_clips(void)
{
    static const struct pel_rect clip[] = {
        {8388608, 0, 8388672, 64},
        {0, 0, -536870912, 64},
        {INT32_MAX, 0, INT32_MIN, 24},
        {0, INT32_MAX, 64, INT32_MIN},
        {INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN},
        {INT32_MIN, INT32_MIN, INT32_MIN, INT32_MIN},
        {40, 0, 20, 64},
        {0, 40, 64, 20},
    };
    static const pel_color colors[3] = {PEL_RGB(9, 8, 7), PEL_RGB(250, 0, 0),
                                        PEL_RGB(0, 3, 99)};
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        const struct drawing d = open_case(&c.random);
        pel_surface_clip(
            &whole.surface,
            &clip[random_word(&c.random) % (sizeof clip / sizeof *clip)]);
        draw(&whole, &d);
        pel_triangle_gouraud(&whole.surface, d.shape.v, colors);
        canvas_check(&whole);
    }
}

int main(void)
{
    return RUN_TESTS(test_bytes_follow_the_rule, test_tiles_equal_the_whole,
                     test_empty_clips);
}
