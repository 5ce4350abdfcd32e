/* Smooth glyphs: what was written as runs is drawn, whatever the clip and the
 * band; bytes that are no runs are refused, or stay inside. */
#include <string.h>

#include "core/format/formats.h"
#include "core/format/argb8888.h"
#include "core/image/text_column.h"
#include "core/image/smooth_glyph.h"
#include "core/paint/paint_dither.h"
#include "core/paint/paint_linear.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"

enum { SIDE = 48, PIXELS = SIDE * SIDE, MOST = 2 * 255 * 255 };

/* A font of one glyph, for 'a'. */
struct one {
    uint8_t level[255 * 255]; /* of the largest step */
    uint8_t bits[MOST];
    uint32_t steps;
    const struct pel_font_kind *kind;
    bool is_raw;
    struct pel_font_glyph glyph;
    struct pel_font_range range;
    struct pel_font_asset font;
};

static const struct pel_font_kind *const kinds[] = {
    &pel_font_smooth_2, &pel_font_smooth, &pel_font_smooth_8};

static int32_t most_of(const struct one *o)
{
    return (1 << o->kind->bits) - 1;
}

static void put(struct one *o, uint32_t value)
{
    const uint32_t bit = o->steps++ * o->kind->bits;
    uint8_t *byte = &o->bits[bit / 8];
    value <<= 8 - o->kind->bits - bit % 8;
    *byte = (uint8_t)(bit % 8 ? *byte | value : value);
}

/* Runs may be cut anywhere: some are, here. */
static void encode(struct random *r, struct one *o, int32_t pixels)
{
    const int32_t most = most_of(o);
    o->steps = 0;
    for (int32_t i = 0, n; i < pixels; i += n) {
        const uint32_t value = o->level[i];
        put(o, value);
        n = 1;
        if (o->is_raw || (value > 0 && (int32_t)value < most))
            continue;
        while (i + n < pixels && o->level[i + n] == value &&
               random_between(r, 0, 200))
            n++;
        int32_t left = n;
        for (; left >= most; left -= most)
            put(o, (uint32_t)most);
        put(o, (uint32_t)left);
    }
}

static uint32_t bytes_of(const struct one *o)
{
    return (o->steps * o->kind->bits + 7) / 8;
}

static void make_font(struct one *o, int32_t width, int32_t height,
                      uint32_t size)
{
    o->glyph = (struct pel_font_glyph){
        o->is_raw ? PEL_FONT_RAW : 0, (uint8_t)width, (uint8_t)height, 0, 0, 7};
    o->range = (struct pel_font_range){'a', 1, 0};
    o->font = (struct pel_font_asset){.magic = PEL_FONT_MAGIC,
                                      .version = PEL_FONT_VERSION,
                                      .ranges = 1,
                                      .glyphs = 1,
                                      .missing = PEL_FONT_NONE,
                                      .size = size,
                                      .range = &o->range,
                                      .glyph = &o->glyph,
                                      .bits = o->bits,
                                      .kind = o->kind};
}

static void choose(struct random *r, struct one *o)
{
    o->kind = kinds[random_between(r, 0, 2)];
    o->is_raw = random_between(r, 0, 3) == 0;
}

static void make(struct random *r, struct one *o)
{
    const int32_t side = random_between(r, 0, 50) ? 24 : 255;
    const int32_t width = random_between(r, 0, side);
    const int32_t height = random_between(r, 0, side);
    choose(r, o);
    for (int32_t i = 0, n; i < width * height; i += n) {
        const int32_t kind = random_between(r, 0, 3);
        n = random_between(r, 1, random_between(r, 0, 9) ? 6 : 400);
        for (int32_t k = i; k < i + n && k < width * height; k++)
            o->level[k] =
                (uint8_t)(kind == 0   ? 0
                          : kind == 1 ? most_of(o)
                                      : random_between(r, 0, most_of(o)));
    }
    encode(r, o, width * height);
    make_font(o, width, height, bytes_of(o));
}

static void print_glyph(const void *value)
{
    const struct pel_font_glyph *g = value;
    print_error("glyph %d x %d px%s\n", g->width, g->height,
                g->offset & PEL_FONT_RAW ? ", raw" : "");
}

static uint8_t expected(const struct one *o, int32_t x, int32_t y)
{
    const bool is_in =
        x >= 0 && y >= 0 && x < o->glyph.width && y < o->glyph.height;
    const int level = is_in ? o->level[y * o->glyph.width + x] : 0;
    return (uint8_t)(level * 255 / most_of(o));
}

static struct pel_surface surface_of(uint8_t *pixels)
{
    struct pel_surface s;
    assert_int_equal(pel_surface_init(&s, &pel_gray8, pixels, PIXELS,
                                      &(struct pel_rect){0, 0, SIDE, SIDE}),
                     PEL_OK);
    return s;
}

static void draw(const struct one *o, struct pel_surface *s, int32_t x,
                 int32_t y)
{
    const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
    const struct pel_text_block text = {&o->font, "a", x, y};
    pel_text(s, &text, &white.paint);
}

TEST(glyphs_are_what_was_written)
{
    static struct one o;
    static uint8_t pixels[PIXELS];
    for (struct cases c = cases_of(3000); cases_next(&c);) {
        struct random *r = &c.random;
        struct pel_surface s = surface_of(pixels);
        make(r, &o);
        cases_keep(print_glyph, &o.glyph, sizeof o.glyph);
        assert_int_equal(pel_font_asset_check(&o.font), PEL_OK);
        const int32_t x = random_between(r, -30, SIDE);
        const int32_t y = random_between(r, -30, SIDE);
        const int32_t cut = random_between(r, 0, SIDE);
        s.clip.x0 = random_between(r, 0, SIDE / 2);
        s.clip.x1 = random_between(r, SIDE / 2, SIDE);
        const struct pel_rect clip = s.clip;
        memset(pixels, 0, sizeof pixels);
        s.clip.y1 = cut;
        draw(&o, &s, x, y);
        s.clip.y0 = cut;
        s.clip.y1 = SIDE;
        draw(&o, &s, x, y);
        for (int32_t i = 0; i < PIXELS; i++) {
            const int32_t at = i % SIDE;
            const bool is_seen = at >= clip.x0 && at < clip.x1;
            if (pixels[i] != (is_seen ? expected(&o, at - x, i / SIDE - y) : 0))
                fail_msg("%d x %d px at %d, %d: pixel %d, %d is %d: %s",
                         o.glyph.width, o.glyph.height, x, y, at, i / SIDE,
                         pixels[i], cases_replay());
        }
    }
}

/* Full pixels are those of a glyph of one bit, whether they come alone or in
 * runs: in every format, of a paint that dithers, and one of half alpha. */
TEST(full_pixels_are_those_of_one_bit)
{
    static struct one o;
    static uint32_t pixels[2][PIXELS];
    static const pel_color black_to_blue[] = {PEL_RGB(0, 0, 0),
                                              PEL_RGB(9, 99, 255)};
    static const struct pel_ramp ramp = {black_to_blue, 2, PEL_PAD};
    static const struct pel_format *const formats[] = {
        &pel_rgb565_le, &pel_rgb565_be, &pel_bgr565_le,  &pel_rgb888,
        &pel_xrgb8888,  &pel_gray8,     &pel_gray4,      &pel_mono1,
        &pel_rgb332,    &pel_argb8888,  &pel_mono1_pages};
    for (struct cases c = cases_of(1500); cases_next(&c);) {
        struct random *r = &c.random;
        uint8_t stencil[SIDE][SIDE / 8] = {{0}};
        const int32_t width = random_between(r, 1, SIDE);
        choose(r, &o);
        for (int32_t i = 0, n; i < width * SIDE; i += n) {
            const int32_t value = random_between(r, 0, 1) ? most_of(&o) : 0;
            n = random_between(r, 1, 12);
            for (int32_t k = i; k < i + n && k < width * SIDE; k++) {
                o.level[k] = (uint8_t)value;
                if (value)
                    stencil[k / width][k % width / 8] |=
                        (uint8_t)(0x80 >> k % width % 8);
            }
        }
        encode(r, &o, width * SIDE);
        make_font(&o, width, SIDE, bytes_of(&o));
        cases_keep(print_glyph, &o.glyph, sizeof o.glyph);
        const struct pel_flat glass = PEL_FLAT(PEL_RGBA(255, 90, 0, 128));
        struct pel_linear slope;
        struct pel_dither dither;
        const struct pel_format *format =
            formats[random_between(r, 0, sizeof formats / sizeof *formats - 1)];
        pel_linear_init(&slope, (struct pel_point){0, 0},
                        (struct pel_point){PEL_PX(SIDE), PEL_PX(9)}, &ramp);
        pel_dither_init(&dither, &slope.base.paint);
        const struct pel_paint *paint =
            random_between(r, 0, 1) ? &glass.paint : &dither.paint;
        for (int k = 0; k < 2; k++) {
            struct pel_surface s;
            memset(pixels[k], 0x35, sizeof pixels[k]);
            assert_int_equal(
                pel_surface_init(&s, format, pixels[k], sizeof pixels[k],
                                 &(struct pel_rect){0, 0, SIDE, SIDE}),
                PEL_OK);
            const struct pel_text_block text = {&o.font, "a", 0, 0};
            const struct pel_stencil g = {stencil[0], SIDE / 8, width, SIDE};
            if (k)
                pel_text(&s, &text, paint);
            else
                pel_glyph(&s, &g, 0, 0, paint);
        }
        if (memcmp(pixels[0], pixels[1], sizeof pixels[0]) != 0)
            fail_msg("format %d, %s: %s", format->id,
                     paint == &glass.paint ? "glass" : "dither",
                     cases_replay());
    }
}

/* A font that passes its check is drawn from inside its bytes, which end where
 * a sanitizer watches. */
TEST(no_bytes_are_read_beyond)
{
    static struct one o;
    static uint8_t pixels[PIXELS];
    uint32_t good = 0;
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        struct random *r = &c.random;
        struct pel_surface s = surface_of(pixels);
        const uint32_t size = (uint32_t)random_between(r, 1, 40);
        uint8_t bits[40];
        for (uint32_t i = 0; i < size; i++)
            bits[40 - size + i] =
                (uint8_t)(random_word(r) >> random_between(r, 0, 24));
        choose(r, &o);
        make_font(&o, random_between(r, 0, 20), random_between(r, 0, 20), size);
        cases_keep(print_glyph, &o.glyph, sizeof o.glyph);
        o.font.bits = bits + 40 - size;
        o.glyph.offset |= (uint32_t)random_between(r, 0, (int32_t)size + 1);
        if (pel_font_asset_check(&o.font) != PEL_OK)
            continue;
        good++;
        draw(&o, &s, random_between(r, -10, SIDE),
             random_between(r, -10, SIDE));
    }
    assert_true(good > 100 || cases_alone());
}

TEST(runs_that_are_cut_off)
{
    static struct one o;
    static const struct {
        uint8_t bytes[3];
        uint32_t size;
        int kind; /* of kinds */
        bool is_raw;
        enum pel_status status;
    } row[] = {
        {{0x09}, 1, 1, false, PEL_OK},                     /* nine of 0 */
        {{0x08}, 1, 1, false, PEL_ERROR_SIZE},             /* one is missing */
        {{0xFF}, 1, 1, false, PEL_ERROR_SIZE},             /* goes on */
        {{0xFF, 0x00}, 2, 1, false, PEL_OK},               /* fifteen */
        {{0x11, 0x11, 0x10}, 3, 1, false, PEL_ERROR_SIZE}, /* a 0 alone */
        {{0}, 0, 1, false, PEL_ERROR_SIZE},
        {{0x3F}, 1, 0, false, PEL_ERROR_SIZE},       /* 3 3 3 goes on */
        {{0x3F, 0x00}, 2, 0, false, PEL_OK},         /* 0, 9: 3 3 3 0 */
        {{0x3E}, 1, 0, false, PEL_ERROR_SIZE},       /* eight of 0 */
        {{0xFF, 0xFF}, 2, 2, false, PEL_ERROR_SIZE}, /* goes on */
        {{0x00, 0x09}, 2, 2, false, PEL_OK},         /* nine of 0 */
        {{0x00, 0xFF, 0x00}, 3, 2, false, PEL_OK},
        {{0, 0, 0}, 3, 0, true, PEL_OK}, /* nine of 12 */
        {{0, 0}, 2, 0, true, PEL_ERROR_SIZE},
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        memcpy(o.bits, row[i].bytes, 3);
        o.kind = kinds[row[i].kind];
        o.is_raw = row[i].is_raw;
        make_font(&o, 3, 3, row[i].size);
        if (pel_font_asset_check(&o.font) != row[i].status)
            fail_msg("row %zu", i);
    }
    o.font.pairs = 1;
    assert_int_equal(pel_font_asset_check(&o.font), PEL_ERROR_NULL);
}

/* Two glyphs of three columns; pairs move the second one, the measured size and
 * where lines break. */
TEST(pairs)
{
    static const uint8_t bits[] = {0xF3}; /* 15, three */
    static const struct pel_font_glyph glyph[] = {{0, 3, 1, 0, 1, 4},
                                                  {0, 3, 1, 0, 1, 4}};
    static const struct pel_font_range range = {'a', 2, 0};
    static const struct pel_font_pair pair[] = {{0, 0, 2}, {0, 1, -1}};
    static const struct pel_font_asset font = {PEL_FONT_MAGIC,
                                               PEL_FONT_VERSION,
                                               1,
                                               0,
                                               1,
                                               2,
                                               PEL_FONT_NONE,
                                               sizeof bits,
                                               &range,
                                               glyph,
                                               bits,
                                               &pel_font_smooth,
                                               pair,
                                               2,
                                               NULL};
    const struct {
        const char *text;
        int32_t width;
    } row[] = {{"ab", 7}, {"aa", 10}, {"ba", 8}, {"aab", 13}, {"a\nb", 4}};
    assert_int_equal(pel_font_asset_check(&font), PEL_OK);
    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        assert_int_equal(pel_text_measure(&font, row[i].text).width,
                         row[i].width);

    uint8_t pixels[PIXELS] = {0};
    struct pel_surface s = surface_of(pixels);
    const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
    const struct pel_text_block text = {&font, "ab", 1, 0};
    pel_text(&s, &text, &white.paint);
    for (int32_t x = 0; x < 10; x++)
        assert_int_equal(pixels[x], x >= 1 && x < 7 ? 255 : 0);

    const struct pel_text_column narrow = {.text = text, .width = 7};
    assert_int_equal(pel_text_column_draw(NULL, &narrow, NULL).height, 1);
}
