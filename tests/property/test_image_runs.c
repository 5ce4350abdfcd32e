/* Pictures of runs, drawn into any format, show the pixels that the test reads
 * from their words by the rule, inside the clip. Words that are cut off, or
 * that are noise, show what comes before the fault; nothing behind them is
 * read, which the sanitizers watch. */
#include <stdlib.h>
#include <string.h>

#include "core/pel.h"
#include "tests/support/canvas.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"
#include "tests/support/shapes.h"

enum { SIDE = 40, WORDS = 4000, SOURCES = LAYOUT_COUNT + 3 };

static struct canvas to;
static pel_color table[256];
static const struct pel_palette palettes[2] = {PEL_PALETTE(4, table),
                                               PEL_PALETTE(8, table)};

/* A picture, and what the words say: the pixels of each row, as numbers of
 * their layout, up to where it breaks off. */
struct source {
    const struct layout *layout; /* of the pixels' bits */
    const struct pel_format *format;
    struct pel_runs_asset asset;
    uint32_t bytes; /* of a word */
    uint8_t words[WORDS * 4];
    uint32_t rows[SIDE];
    uint16_t rows16[SIDE];
    uint32_t pixel[SIDE][SIDE];
    int32_t known[SIDE];
};
static struct source from;

/* The layouts, but for that of pages; then argb8888 and both palettes. */
static void choose_format(struct source *s, uint64_t number)
{
    const struct pel_format *const memory[] = {&pel_xrgb8888, &pel_gray4,
                                               &pel_gray8};
    const struct pel_format *const format[] = {
        &pel_argb8888, &palettes[0].format, &palettes[1].format};
    number %= SOURCES;
    if (number < LAYOUT_COUNT &&
        layouts[number].format->id != PEL_FORMAT_MONO1_PAGES) {
        s->layout = &layouts[number];
        s->format = s->layout->format;
    } else {
        number = number < LAYOUT_COUNT ? 0 : number - LAYOUT_COUNT;
        s->layout = layout_of(memory[number]);
        s->format = format[number];
    }
    s->bytes = (uint32_t)(s->layout->bits + 7) / 8;
}

static void put_word(struct source *s, uint32_t word)
{
    for (uint32_t k = 0; k < s->bytes; k++)
        s->words[s->asset.size * s->bytes + k] = (uint8_t)(word >> 8 * k);
    s->asset.size++;
}

/* Runs and words as they are, of few values, for the width and at times more.
 */
static void make_row(struct source *s, struct random *r)
{
    const int32_t pixels = s->layout->bits < 8 ? 8 / s->layout->bits : 1;
    for (int32_t left = s->asset.width; left > 0;) {
        const int32_t n = random_between(r, 1, 12);
        const bool is_run = random_word(r) % 2;
        const uint32_t value = random_word(r);
        put_word(s, 2 * (uint32_t)n + is_run);
        for (int32_t i = is_run ? 1 : n; i > 0; i--)
            put_word(s, i % 3 ? random_word(r) : value);
        left -= n * pixels;
    }
}

static void make(struct source *s, struct random *r, int kind)
{
    s->asset = (struct pel_runs_asset){PEL_RUNS_MAGIC,
                                       PEL_RUNS_VERSION,
                                       s->format->id,
                                       (uint16_t)random_between(r, 1, SIDE),
                                       (uint16_t)random_between(r, 1, SIDE),
                                       0,
                                       NULL,
                                       NULL,
                                       NULL};
    for (int32_t y = 0; y < s->asset.height; y++) {
        s->rows[y] = s->asset.size;
        if (y > 0 && random_word(r) % 4 == 0)
            s->rows[y] = s->rows[random_between(r, 0, y - 1)];
        else
            make_row(s, r);
    }
    if (kind == 1)
        s->asset.size = random_word(r) % (s->asset.size + 1);
    for (uint32_t i = 0; kind == 2 && i < s->asset.size * s->bytes; i++)
        s->words[i] = (uint8_t)(random_word(r) >> random_word(r) % 24);
    for (int32_t y = 0; kind == 2 && y < s->asset.height; y++)
        if (random_word(r) % 4 == 0)
            s->rows[y] = random_word(r) >> random_word(r) % 32;
}

static uint32_t value_of(const struct source *s, uint32_t at)
{
    uint32_t value = 0;
    for (uint32_t k = 0; k < s->bytes; k++)
        value |= (uint32_t)s->words[at * s->bytes + k] << 8 * k;
    return value;
}

/* Pixel i of the word at `at`. */
static uint32_t pixel_of(const struct source *s, uint32_t at, int32_t i)
{
    const int bits = s->layout->bits;
    return bits < 8
               ? value_of(s, at) >> (8 - bits * (i + 1)) & ((1u << bits) - 1)
               : value_of(s, at);
}

static void read_row(struct source *s, int32_t y)
{
    const int32_t pixels = s->layout->bits < 8 ? 8 / s->layout->bits : 1;
    int32_t *x = &s->known[y];
    uint64_t at = s->rows[y];
    *x = 0;
    while (*x < s->asset.width && at + 1 < s->asset.size) {
        const uint32_t count =
            value_of(s, (uint32_t)at++) & (s->bytes > 1 ? 0xFFFF : 0xFF);
        const uint32_t n = count / 2, words = count % 2 ? 1 : n;
        if (n == 0 || at + words > s->asset.size)
            return;
        for (uint32_t i = 0; i < n; i++)
            for (int32_t k = 0; k < pixels && *x < s->asset.width; k++)
                s->pixel[y][(*x)++] = count % 2
                                          ? pixel_of(s, (uint32_t)at, 0)
                                          : pixel_of(s, (uint32_t)(at + i), k);
        at += words;
    }
}

static pel_color color_of(const struct source *s, uint32_t pixel)
{
    if (s->format->id == PEL_FORMAT_ARGB8888)
        return pixel;
    return s->format == s->layout->format ? layout_unpack(s->layout, pixel)
                                          : table[pixel];
}

struct drawn {
    int32_t x, y;
    uint32_t alpha;
};

static pel_color color_at(const void *drawn, int32_t x, int32_t y)
{
    const struct drawn *d = drawn;
    const struct pel_rect *clip = &to.surface.clip;
    const int32_t column = x - d->x, row = y - d->y;
    if (x < clip->x0 || x >= clip->x1 || y < clip->y0 || y >= clip->y1 ||
        row < 0 || row >= from.asset.height || column < 0 ||
        column >= from.known[row])
        return 0;
    const pel_color c = color_of(&from, from.pixel[row][column]);
    return (c & UINT32_C(0xFFFFFF)) | ((c >> 24) * d->alpha * 2 + 255) / 510
                                          << 24;
}

/* From memory of just that size. */
static void draw(const struct drawn *d, bool is_short)
{
    const size_t size = from.asset.size * from.bytes;
    void *words = malloc(size ? size : 1);
    assert_non_null(words);
    memcpy(words, from.words, size);
    from.asset.words = words;
    from.asset.rows16 = is_short ? from.rows16 : NULL;
    from.asset.rows32 = is_short ? NULL : from.rows;
    assert_int_equal(pel_runs_asset_check(&from.asset, from.format), PEL_OK);
    const struct pel_runs_part part = {&from.asset, from.format, d->x, d->y};
    pel_copy_runs(&to.surface, &part, (uint8_t)d->alpha);
    free(words);
}

TEST(every_format)
{
    for (struct cases c = cases_of(60000); cases_next(&c);) {
        struct random *r = &c.random;
        const struct pel_rect b = shape_bounds(r, SIDE, SIDE);
        choose_format(&from, c.next);
        canvas_open(&to, layouts[c.next / SOURCES % LAYOUT_COUNT].format, &b,
                    random_word(r) % CANVAS_STYLES);
        const struct pel_rect clip = shape_clip(r, &b);
        pel_surface_clip(&to.surface, &clip);
        for (int i = 0; i < 256; i++)
            table[i] = random_word(r) | (i % 3 ? PEL_RGB(0, 0, 0) : 0);
        make(&from, r, random_between(r, 0, 2));
        bool is_short = random_word(r) % 2;
        for (int32_t y = 0; y < from.asset.height; y++) {
            from.rows16[y] = (uint16_t)from.rows[y];
            is_short = is_short && from.rows16[y] == from.rows[y];
            read_row(&from, y);
        }
        const struct drawn d = {b.x0 + random_between(r, -SIDE, SIDE),
                                b.y0 + random_between(r, -SIDE, SIDE),
                                random_word(r) % 2 ? 255 - random_word(r) % 2
                                                   : random_word(r) & 255};
        draw(&d, is_short);
        canvas_check_drawn(&to, NULL, color_at, &d);
    }
}

static void draw_line(const struct pel_surface *line, const void *words,
                      uint32_t size, const struct pel_format *format, int32_t x)
{
    static const uint16_t rows[1] = {0};
    const struct pel_runs_asset asset = {PEL_RUNS_MAGIC,
                                         PEL_RUNS_VERSION,
                                         format->id,
                                         32767,
                                         1,
                                         size,
                                         words,
                                         rows,
                                         NULL};
    pel_copy_runs(line, &(struct pel_runs_part){&asset, format, x, 0}, 255);
}

/* The longest count of both sizes of words, and places out of range. */
TEST(ends_of_ranges)
{
    static const uint8_t bytes[] = {255, 9, 254, 1, 2, 3};
    static const union {
        uint8_t bytes[4];
        uint16_t word;
    } pixels = {{255, 255, 255, 255}};
    static uint8_t memory[32767];
    const struct pel_surface line =
        surface_of(&pel_gray8, memory, sizeof memory, 32767, 1);
    draw_line(&line, pixels.bytes, 2, &pel_rgb565_le, 65537);
    draw_line(&line, pixels.bytes, 2, &pel_rgb565_le, -65537);
    assert_int_equal(memory[0], 0);
    draw_line(&line, pixels.bytes, 2, &pel_rgb565_le, 0);
    for (int i = 0; i < 32767; i++)
        assert_int_equal(memory[i], 255);
    draw_line(&line, bytes, sizeof bytes, &pel_gray8, 0);
    for (int i = 0; i < 127; i++)
        assert_int_equal(memory[i], 9);
    assert_int_equal(memory[127], 255); /* 127 words are not there */
}

TEST(what_is_refused)
{
    static const uint32_t words[2] = {0, 0};
    static const uint16_t rows[1] = {0};
    const struct pel_runs_asset good = {PEL_RUNS_MAGIC,
                                        PEL_RUNS_VERSION,
                                        PEL_FORMAT_GRAY8,
                                        1,
                                        1,
                                        8,
                                        words,
                                        rows,
                                        NULL};
    struct pel_runs_asset a = good;
    assert_int_equal(pel_runs_asset_check(&a, &pel_gray8), PEL_OK);
    assert_int_equal(pel_runs_asset_check(NULL, &pel_gray8), PEL_ERROR_NULL);
    assert_int_equal(pel_runs_asset_check(&a, NULL), PEL_ERROR_NULL);
    assert_int_equal(pel_runs_asset_check(&a, &pel_gray4), PEL_ERROR_FORMAT);
    a.rows32 = words;
    assert_int_equal(pel_runs_asset_check(&a, &pel_gray8), PEL_ERROR_NULL);
    a = good;
    a.words = NULL;
    assert_int_equal(pel_runs_asset_check(&a, &pel_gray8), PEL_ERROR_NULL);
    a = good;
    a.version++;
    assert_int_equal(pel_runs_asset_check(&a, &pel_gray8), PEL_ERROR_RANGE);
    a = good;
    a.magic = PEL_IMAGE_MAGIC;
    assert_int_equal(pel_runs_asset_check(&a, &pel_gray8), PEL_ERROR_RANGE);
    a = good;
    a.width = 0;
    assert_int_equal(pel_runs_asset_check(&a, &pel_gray8), PEL_ERROR_SIZE);
    a = good;
    a.height = 32768;
    assert_int_equal(pel_runs_asset_check(&a, &pel_gray8), PEL_ERROR_SIZE);
    a = good;
    a.format = PEL_FORMAT_MONO1_PAGES;
    assert_int_equal(pel_runs_asset_check(&a, &pel_mono1_pages),
                     PEL_ERROR_FORMAT);
    a.format = PEL_FORMAT_RGB565_LE;
    assert_int_equal(pel_runs_asset_check(&a, &pel_rgb565_le_fill),
                     PEL_ERROR_FORMAT);
}
