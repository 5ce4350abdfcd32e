/* Blend modes: of every shape and format each pixel is what the mode makes of
 * the pixel that was there and of the paint, whatever the tiles; edges of
 * smooth shapes are weighed as by a mask; xor twice changes nothing. */
#include <stdio.h>
#include <string.h>

#include "tests/support/any_shape.h"
#include "tests/support/canvas.h"
#include "tests/support/check.h"
#include "tests/support/shapes.h"

static struct canvas drawn, other;
static struct hits hits;

/* What is drawn: one color, or a checker of two. */
struct drawing {
    enum pel_blend_mode mode;
    bool is_checker;
    struct pel_flat flat;
    struct any_shape shape;
    struct pel_checker checker;
    struct pel_blend blend;
};

static void print(const void *value)
{
    const struct drawing *const d = value;
    fprintf(stderr, "mode %d, %s %08x\n", (int)d->mode,
            d->is_checker ? "checker with" : "flat", (unsigned)d->flat.color);
}

/* Points into itself: stays where it is. */
static void random_drawing(struct random *r, struct drawing *d)
{
    static const struct pel_checker_fields fields = {3, 2, 1, 1};
    const struct pel_rect bounds = shape_bounds(r, 40, 40);
    const pel_color solid = random_word(r) % 2 ? 0xFF000000 : 0;
    const struct pel_format *const format =
        layouts[random_word(r) % LAYOUT_COUNT].format;
    canvas_open(&drawn, format, &bounds, random_word(r) % CANVAS_STYLES);
    canvas_open(&other, format, &bounds, random_word(r) % CANVAS_STYLES);
    any_in_box(r, &d->shape, (enum any_kind)(random_word(r) % ANY_KINDS),
               &bounds);
    d->flat = (struct pel_flat)PEL_FLAT(random_word(r) | solid);
    d->mode = (enum pel_blend_mode)(random_word(r) % 3);
    d->is_checker = random_word(r) % 2;
    assert_int_equal(pel_checker_init(&d->checker, &fields, d->flat.color,
                                      random_word(r) | solid),
                     PEL_OK);
    assert_int_equal(
        pel_blend_init(&d->blend,
                       d->is_checker ? &d->checker.base.paint : &d->flat.paint,
                       d->mode),
        PEL_OK);
    cases_keep(print, d, sizeof *d < CASES_PART ? sizeof *d : CASES_PART);
}

static pel_color source_at(const struct drawing *d, int32_t x, int32_t y)
{
    pel_color color = d->flat.color;
    if (d->is_checker)
        d->checker.base.colors(&d->checker.base, x, y, 1, &color);
    return color;
}

/* As the header says it, by other means. */
static int channel(enum pel_blend_mode mode, int d, int s)
{
    int bits = 0;
    if (mode == PEL_BLEND_ADD)
        return d + s < 255 ? d + s : 255;
    if (mode == PEL_BLEND_MULTIPLY)
        return (2 * d * s + 255) / 510;
    for (int bit = 1; bit < 256; bit *= 2)
        bits += d / bit % 2 != s / bit % 2 ? bit : 0;
    return bits;
}

static pel_color combined(enum pel_blend_mode mode, pel_color d, pel_color s)
{
    return PEL_RGBA(channel(mode, (int)pel_red(d), (int)pel_red(s)),
                    channel(mode, (int)pel_green(d), (int)pel_green(s)),
                    channel(mode, (int)pel_blue(d), (int)pel_blue(s)),
                    pel_alpha(s));
}

static pel_color color_at(const void *drawing, int32_t x, int32_t y)
{
    const struct drawing *const d = drawing;
    const pel_color below =
        layout_unpack(drawn.layout, canvas_pixel_before(&drawn, x, y));
    return combined(d->mode, below, source_at(d, x, y));
}

TEST(pixels)
{
    static struct drawing d;
    for (struct cases c = cases_of(60000); cases_next(&c);) {
        random_drawing(&c.random, &d);
        hits_open(&hits, &drawn.surface.bounds);
        any_draw(&hits.surface, &d.shape, &hits.paint);
        any_draw(&drawn.surface, &d.shape, &d.blend.paint);
        canvas_check_drawn(&drawn, &hits, color_at, &d);
    }
}

TEST(clip_is_crop)
{
    static struct drawing d;
    for (struct cases c = cases_of(30000); cases_next(&c);) {
        random_drawing(&c.random, &d);
        const struct pel_rect clip =
            shape_clip(&c.random, &drawn.surface.bounds);
        const bool smooth = random_word(&c.random) % 2;
        pel_surface_clip(&other.surface, &clip);
        for (int i = 0; i < 2; i++) {
            const struct pel_surface *const s =
                i ? &other.surface : &drawn.surface;
            if (!smooth || !any_draw_smooth(s, &d.shape, &d.blend.paint))
                any_draw(s, &d.shape, &d.blend.paint);
        }
        canvas_check_part(&drawn, &other);
    }
}

TEST(edges_are_a_mask)
{
    static const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
    static uint8_t gray[40 * 40];
    static struct drawing d;
    for (struct cases c = cases_of(30000); cases_next(&c);) {
        struct pel_surface mask;
        struct pel_masked masked;
        random_drawing(&c.random, &d);
        const struct pel_rect b = drawn.surface.bounds;
        memset(gray, 0, sizeof gray);
        assert_int_equal(
            pel_surface_init(&mask, &pel_gray8, gray, sizeof gray, &b), PEL_OK);
        if (!any_draw_smooth(&drawn.surface, &d.shape, &d.blend.paint))
            continue;
        any_draw_smooth(&mask, &d.shape, &white.paint);
        assert_int_equal(
            pel_masked_init(&masked, &mask, b.x0, b.y0, d.blend.source),
            PEL_OK);
        d.blend.source = &masked.base.paint;
        pel_box(&other.surface, &b, &d.blend.paint);
        canvas_check_same(&other, &drawn);
    }
}

/* Any color in formats of red, green and blue, a grey one in those of grey. */
TEST(xor_twice_is_nothing)
{
    static struct drawing d;
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        random_drawing(&c.random, &d);
        if (drawn.layout->inks)
            continue;
        d.is_checker = false;
        d.flat.color |= 0xFF000000;
        if (drawn.layout->gray)
            d.flat.color = 0xFF000000 | pel_blue(d.flat.color) * 0x010101;
        d.blend.mode = PEL_BLEND_XOR;
        d.blend.source = &d.flat.paint;
        any_draw(&drawn.surface, &d.shape, &d.blend.paint);
        any_draw(&drawn.surface, &d.shape, &d.blend.paint);
        for (int32_t y = drawn.surface.bounds.y0; y < drawn.surface.bounds.y1;
             y++)
            for (int32_t x = drawn.surface.bounds.x0;
                 x < drawn.surface.bounds.x1; x++) {
                const uint32_t unused = drawn.layout->unused;
                if ((canvas_pixel(&drawn, x, y) | unused) !=
                    (canvas_pixel_before(&drawn, x, y) | unused))
                    fail_msg("%s at %d, %d; %s", drawn.layout->name, x, y,
                             cases_replay());
            }
    }
}

/* A dither goes around: on a plain background it shows what it shows of the
 * color that the mode makes. */
TEST(dither_around)
{
    static struct drawing d;
    for (struct cases c = cases_of(5000); cases_next(&c);) {
        struct pel_dither around, plain;
        pel_color below = random_word(&c.random);
        random_drawing(&c.random, &d);
        pel_clear(&drawn.surface, below);
        pel_clear(&other.surface, below);
        below = layout_unpack(drawn.layout, layout_pack(drawn.layout, below));
        const struct pel_flat flat =
            PEL_FLAT(combined(d.mode, below, d.flat.color | 0xFF000000));
        d.flat.color |= 0xFF000000;
        d.blend.source = &d.flat.paint;
        assert_int_equal(pel_dither_init(&around, &d.blend.paint), PEL_OK);
        assert_int_equal(pel_dither_init(&plain, &flat.paint), PEL_OK);
        any_draw(&drawn.surface, &d.shape, &around.paint);
        any_draw(&other.surface, &d.shape, &plain.paint);
        canvas_check_same(&other, &drawn);
    }
}

TEST(errors)
{
    static const struct pel_flat flat = PEL_FLAT(PEL_RGB(1, 2, 3));
    struct pel_blend b;
    assert_int_equal(pel_blend_init(NULL, &flat.paint, PEL_BLEND_ADD),
                     PEL_ERROR_NULL);
    assert_int_equal(pel_blend_init(&b, NULL, PEL_BLEND_ADD), PEL_ERROR_NULL);
    assert_ptr_equal(b.paint.fill, pel_nothing_fill);
    assert_int_equal(pel_blend_init(&b, &b.paint, PEL_BLEND_ADD),
                     PEL_ERROR_RANGE);
    assert_int_equal(pel_blend_init(&b, &flat.paint, (enum pel_blend_mode)3),
                     PEL_ERROR_RANGE);
    assert_ptr_equal(b.paint.fill, pel_nothing_fill);
}
