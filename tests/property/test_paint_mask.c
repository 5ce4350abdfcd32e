/* Masks: one of 1 bit shows what the stencil with its bits shows of any paint,
 * and the grey of a pixel weighs the alpha of a color. */
#include <string.h>

#include "core/pel.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"
#include "tests/support/layouts.h"

enum { SIDE = 40, WIDTH = 27, HEIGHT = 19, BYTES = WIDTH * HEIGHT };

static uint8_t bits[BYTES];
static uint32_t memory[2][SIDE * SIDE];
static struct pel_surface screen[2];

static void set_up(struct random *r, const struct pel_format *format)
{
    const struct pel_rect clip = {
        random_between(r, -9, SIDE), random_between(r, -9, SIDE),
        random_between(r, 0, SIDE + 9), random_between(r, 0, SIDE + 9)};
    for (int i = 0; i < SIDE * SIDE; i++)
        memory[0][i] = memory[1][i] = random_word(r);
    for (int i = 0; i < 2; i++) {
        screen[i] = surface_of(format, memory[i], sizeof memory[i], SIDE, SIDE);
        pel_surface_clip(&screen[i], &clip);
    }
    for (int i = 0; i < BYTES; i++)
        bits[i] = (uint8_t)(random_word(r) >> (random_word(r) & 31));
}

static void check_screens(const struct pel_masked *masked, const char *what)
{
    if (memcmp(memory[0], memory[1], sizeof memory[0]) != 0)
        fail_msg("%s, format %d at %d, %d: %s", what, screen[0].format->id,
                 masked->box.x0, masked->box.y0, cases_replay());
}

/* A paint that is flat, a gradient or a texture, translucent or not. */
static const struct pel_paint *make_paint(struct random *r)
{
    static struct pel_flat flat;
    static struct pel_linear linear;
    static struct pel_texture texture;
    static pel_color colors[4];
    static const struct pel_ramp ramp = {colors, 3, PEL_REFLECT};
    static const struct pel_texels texels = {NULL, colors, 2, 2, false};
    static const struct pel_texture_map map = PEL_TEXTURE_AT(3, 4);
    const struct pel_point from = PEL_AT(3, 5),
                           to = {PEL_PX(9), random_between(r, 0, 9999)};
    const pel_color solid = random_word(r) % 2 ? PEL_RGB(0, 0, 0) : 0;
    for (int i = 0; i < 4; i++)
        colors[i] = random_word(r) | solid;
    flat = (struct pel_flat)PEL_FLAT(colors[0]);
    assert_int_equal(pel_linear_init(&linear, from, to, &ramp), PEL_OK);
    assert_int_equal(pel_texture_init_nearest(&texture, &texels, &map), PEL_OK);
    texture.wrap_u = texture.wrap_v = PEL_WRAP_REPEAT;
    const struct pel_paint *const kinds[3] = {&flat.paint, &linear.base.paint,
                                              &texture.base.paint};
    return kinds[random_word(r) % 3];
}

TEST(one_bit_is_a_stencil)
{
    const struct pel_stencil stencil = {bits, (WIDTH + 7) / 8, WIDTH, HEIGHT};
    const struct pel_surface mask =
        surface_of(&pel_mono1, bits, sizeof bits, WIDTH, HEIGHT);
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        struct random *r = &c.random;
        struct pel_masked masked;
        struct pel_dither inside, around;
        const int32_t x = random_between(r, -WIDTH, SIDE);
        const int32_t y = random_between(r, -HEIGHT, SIDE);
        const struct pel_paint *paint = make_paint(r),
                               *behind = &masked.base.paint;
        set_up(r, layouts[random_word(r) % LAYOUT_COUNT].format);
        assert_int_equal(pel_masked_init(&masked, &mask, x, y, paint), PEL_OK);
        if (random_word(r) % 2) {
            assert_int_equal(pel_dither_init(&inside, paint), PEL_OK);
            assert_int_equal(pel_dither_init(&around, behind), PEL_OK);
            paint = &inside.paint;
            behind = &around.paint;
        }
        pel_box(&screen[0], &screen[0].bounds, behind);
        pel_glyph(&screen[1], &stencil, x, y, paint);
        check_screens(&masked, "one bit");
    }
}

TEST(grey_weighs_alpha)
{
    static const struct pel_format *const formats[] = {&pel_gray8, &pel_gray4,
                                                       &pel_mono1};
    for (struct cases c = cases_of(3000); cases_next(&c);) {
        struct random *r = &c.random;
        const struct pel_surface mask = surface_of(
            formats[random_word(r) % 3], bits, sizeof bits, WIDTH, HEIGHT);
        const pel_color color =
            random_word(r) | (random_word(r) % 2) * 0xFF000000;
        const struct pel_flat flat = PEL_FLAT(color);
        const struct pel_rect *clip = &screen[1].clip;
        struct pel_masked masked;
        set_up(r, layouts[random_word(r) % LAYOUT_COUNT].format);
        assert_int_equal(pel_masked_init(&masked, &mask, 5, 7, &flat.paint),
                         PEL_OK);
        pel_box(&screen[0], &screen[0].bounds, &masked.base.paint);
        for (int32_t y = clip->y0; y < clip->y1; y++)
            for (int32_t x = clip->x0; x < clip->x1; x++) {
                pel_color grey, put;
                if (x < 5 || x >= 5 + WIDTH || y < 7 || y >= 7 + HEIGHT)
                    continue;
                mask.format->load(&mask, x - 5, y - 7, 1, &grey);
                const uint32_t product = pel_alpha(color) * pel_red(grey);
                put = (color & 0xFFFFFF) | (2 * product + 255) / 510 << 24;
                screen[1].format->put(&screen[1], x, y, 1, &put);
            }
        check_screens(&masked, "grey");
    }
}

TEST(errors)
{
    static const struct pel_flat flat = PEL_FLAT(PEL_RGB(1, 2, 3));
    struct pel_surface mask =
        surface_of(&pel_gray8, bits, sizeof bits, WIDTH, HEIGHT);
    struct pel_masked m;
    const struct pel_paint *p = &flat.paint;
    assert_int_equal(pel_masked_init(NULL, &mask, 0, 0, p), PEL_ERROR_NULL);
    assert_int_equal(pel_masked_init(&m, NULL, 0, 0, p), PEL_ERROR_NULL);
    assert_int_equal(pel_masked_init(&m, &mask, 0, 0, NULL), PEL_ERROR_NULL);
    assert_int_equal(pel_masked_init(&m, &mask, 32768, 0, p), PEL_ERROR_RANGE);
    assert_int_equal(pel_masked_init(&m, &mask, 0, 0, &m.base.paint),
                     PEL_ERROR_RANGE);
    assert_int_equal(pel_masked_init(&m, &mask, 0, -32769, p), PEL_ERROR_RANGE);
    mask.format = &pel_rgb565_le_fill;
    assert_int_equal(pel_masked_init(&m, &mask, 0, 0, p), PEL_ERROR_FORMAT);
    assert_ptr_equal(m.base.paint.fill, pel_nothing_fill);
}
