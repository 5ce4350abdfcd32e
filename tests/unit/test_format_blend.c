/* Blending again and again: where 8-bit state comes to rest. */
#include <string.h>

#include "core/format/argb8888.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"
#include "tests/support/layouts.h"

static uint32_t pixels[64];
static const struct pel_point screen[2] = {PEL_AT(0, 0), PEL_AT(8, 8)};

/* The value of the 64 pixels; all are alike. */
static uint32_t pixel_of(const struct pel_surface *s)
{
    pel_color c[8];
    for (int32_t y = 0; y < 8; y++) {
        s->format->load(s, 0, y, 8, c);
        for (int i = 1; i < 8; i++)
            assert_int_equal(c[i], c[0]);
    }
    return c[0];
}

static uint32_t blended(const struct pel_format *format, pel_color start,
                        pel_color color, int times)
{
    const struct pel_flat flat = PEL_FLAT(color);
    struct pel_surface s;
    s = surface_of(format, pixels, sizeof pixels, 8, 8);
    pel_clear(&s, start);
    for (int i = 0; i < times; i++)
        pel_rectangle(&s, screen[0], screen[1], &flat.paint);
    return pixel_of(&s);
}

/* White with alpha 16 adds round(16 (255 - d) / 255), which is 0 as soon as
 * 16 (255 - d) < 127.5, that is from d = 248 on; 247 is 8 away and gains 1. So
 * 2000 blends leave 248, where a shift by 8 for the division would stop at 225.
 * Black over white is the mirror image: 7 remain. */
TEST(white_comes_to_rest_at_248)
{
    static const struct pel_format *const formats[] = {
        &pel_xrgb8888, &pel_xbgr8888, &pel_rgbx8888, &pel_bgrx8888,
        &pel_rgb888,   &pel_bgr888,   &pel_gray8};
    const pel_color black = PEL_RGB(0, 0, 0), white = PEL_RGB(255, 255, 255);
    for (size_t f = 0; f < sizeof formats / sizeof formats[0]; f++) {
        assert_int_equal(
            blended(formats[f], black, PEL_RGBA(255, 255, 255, 16), 2000),
            PEL_RGB(248, 248, 248));
        assert_int_equal(
            blended(formats[f], white, PEL_RGBA(0, 0, 0, 16), 2000),
            PEL_RGB(7, 7, 7));
    }
}

/* Ways to draw n pixels of one color at the left of the first line: the rows
 * of a shape, an unclipped triangle, and colors one by one. */
enum way { BY_ROWS, BY_TRIANGLE, BY_COLORS, WAYS };

static void draw_run(const struct pel_surface *s, int n, pel_color color,
                     enum way way)
{
    const struct pel_flat flat = PEL_FLAT(color);
    const struct pel_point box[2] = {PEL_AT(0, 0), PEL_AT(n, 1)};
    /* n px wide where it passes the centres of line 0. */
    const struct pel_point corner[3] = {PEL_AT(0, 0), PEL_AT(2 * n, 0),
                                        PEL_AT(0, 1)};
    pel_color colors[8];
    for (int i = 0; i < n; i++)
        colors[i] = color;
    if (way == BY_ROWS)
        pel_rectangle(s, box[0], box[1], &flat.paint);
    else if (way == BY_TRIANGLE)
        pel_triangle(s, corner, &flat.paint);
    else
        pel_put_colors(s, 0, 0, n, colors);
}

/* Pixel i of the first line, its lowest byte first in memory. */
static uint32_t value_of(const uint8_t *bytes, int bits, int i)
{
    uint32_t value = 0;
    for (int k = bits / 8; k-- > 0;)
        value = value << 8 | bytes[i * bits / 8 + k];
    return value;
}

static void check_x_bytes(const struct pel_format *format,
                          const struct layout *l, pel_color color, int n)
{
    uint8_t before[64], after[64];
    struct pel_surface s;
    for (int way = 0; way < WAYS; way++) {
        for (int i = 0; i < 64; i++)
            before[i] = (uint8_t)(i * 37 % 128); /* no X bit is set */
        memcpy(pixels, before, sizeof before);
        s = surface_of(format, pixels, sizeof pixels, 512 / format->bits, 1);
        draw_run(&s, n, color, (enum way)way);
        memcpy(after, pixels, sizeof after);
        for (int i = 0; i < 512 / format->bits; i++) {
            const uint32_t was = value_of(before, format->bits, i);
            const uint32_t want = i < n ? layout_over(l, was, color) : was;
            const uint32_t got = value_of(after, format->bits, i);
            if (got != want)
                fail_msg("format %d, alpha %u, way %d, pixel %d of %d: was "
                         "%08x, expected %08x, got %08x",
                         format->id, color >> 24, way, i, n, was, want, got);
        }
    }
}

/* Alpha 0 leaves the X byte as it is, every other alpha sets it: in the formats
 * that have one, and in argb8888, where it is the alpha of the pixel. */
TEST(x_bytes)
{
    static const struct pel_format *const formats[] = {
        &pel_xrgb8888, &pel_xbgr8888, &pel_rgbx8888,
        &pel_bgrx8888, &pel_argb8888, &pel_xrgb1555_le};
    static const uint32_t alphas[] = {0, 1, 128, 254, 255};
    for (size_t f = 0; f < sizeof formats / sizeof formats[0]; f++) {
        const struct layout *l =
            layout_of(formats[f] == &pel_argb8888 ? &pel_xrgb8888 : formats[f]);
        for (size_t i = 0; i < sizeof alphas / sizeof alphas[0]; i++)
            for (int n = 1; n <= 8; n++)
                check_x_bytes(formats[f], l, alphas[i] << 24 | 0x40C864, n);
    }
}

/* Runs of colors with any alphas, opaque ones side by side. */
static void random_colors(struct random *r, pel_color *colors, int n)
{
    for (int i = 0, left = 0; i < n; i++, left--) {
        if (left < -3)
            left = random_between(r, 0, 20);
        colors[i] = random_word(r) | (left > 0 ? 0xFF000000u : 0u);
    }
}

enum { WIDTH = 48 };

/* Eights that are all clear or all opaque, most of them but for one bit of one
 * alpha: vectors test the alphas of eight colors at once. */
static void random_eights(struct random *r, pel_color colors[WIDTH])
{
    for (int i = 0; i < WIDTH; i += 8) {
        const uint32_t alpha = random_word(r) % 2 ? 0xFF000000u : 0;
        for (int k = i; k < i + 8; k++)
            colors[k] = (random_word(r) & 0xFFFFFFu) | alpha;
        colors[i + random_between(r, 0, 7)] ^= 1u << random_between(r, 22, 31);
    }
}

/* put, of every format: what the rule makes of every pixel, and no other. */
TEST(put)
{
    uint8_t memory[WIDTH * 4];
    pel_color colors[WIDTH], was[WIDTH], got[WIDTH];
    struct pel_surface s;
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        const struct layout *l = &layouts[c.next % LAYOUT_COUNT];
        const int x = random_between(&c.random, 0, WIDTH - 1);
        const int n = random_between(&c.random, 1, WIDTH - x);
        for (int i = 0; i < WIDTH * 4; i++)
            memory[i] = (uint8_t)random_word(&c.random);
        memcpy(pixels, memory, sizeof memory);
        if (random_word(&c.random) % 2)
            random_colors(&c.random, colors, n);
        else
            random_eights(&c.random, colors);
        s = surface_of(l->format, pixels, sizeof pixels, WIDTH, 1);
        l->format->load(&s, 0, 0, WIDTH, was);
        l->format->put(&s, x, 0, n, colors);
        l->format->load(&s, 0, 0, WIDTH, got);
        for (int i = 0; i < WIDTH; i++) {
            const uint32_t before = layout_pack(l, was[i]);
            const uint32_t want = i < x || i >= x + n
                                      ? before
                                      : layout_over(l, before, colors[i - x]);
            if (got[i] != layout_unpack(l, want))
                fail_msg("%s: pixel %d of [%d, %d) was %08x, %08x over it: "
                         "expected %08x, got %08x; %s",
                         l->name, i, x, x + n, was[i],
                         colors[i < x || i >= x + n ? 0 : i - x],
                         layout_unpack(l, want), got[i], cases_replay());
        }
    }
}
