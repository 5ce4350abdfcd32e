#include "sim/font/asset.h"

#include <stdlib.h>
#include <string.h>

#include "core/image/smooth_glyph.h"
#include "sim/cli/message.h"

struct rows {
    uint8_t *bits; /* as the asset has them */
    size_t size;
    struct pel_font_glyph *glyph;
};

static int by_bits(const void *a, const void *b)
{
    const struct rows *x = a, *y = b;
    if (x->size != y->size)
        return x->size < y->size ? -1 : 1;
    const int order = x->size ? memcmp(x->bits, y->bits, x->size) : 0;
    return order ? order : (x->glyph > y->glyph) - (x->glyph < y->glyph);
}

/* Stores rows one behind the other, equal ones once; returns their bytes. */
static size_t place_rows(uint8_t *to, const struct rows *rows, size_t count)
{
    size_t size = 0;
    for (size_t i = 0; i < count; i++, rows++) {
        if (i == 0 || rows->size != rows[-1].size ||
            memcmp(rows->bits, rows[-1].bits, rows->size) != 0) {
            memcpy(to + size, rows->bits, rows->size);
            size += rows->size;
        }
        rows->glyph->offset |= (uint32_t)(size - rows->size);
    }
    return size;
}

/* The steps of a smooth glyph (core/image/smooth_glyph.h). */
struct steps {
    uint8_t *at; /* all 0 */
    size_t bits, count;
};

static void put_step(struct steps *s, unsigned value)
{
    const size_t bit = s->count++ * s->bits;
    s->at[bit / 8] |= (uint8_t)(value << (8 - s->bits - bit % 8));
}

static unsigned step_of(uint8_t level, unsigned most)
{
    return (level * most + 127) / 255;
}

static void put_runs(struct steps *s, const uint8_t *level, size_t pixels)
{
    const unsigned most = (1u << s->bits) - 1;
    for (size_t i = 0, run = 1; i < pixels; i += run) {
        const unsigned value = step_of(level[i], most);
        put_step(s, value);
        run = 1;
        if (value > 0 && value < most)
            continue;
        while (i + run < pixels && step_of(level[i + run], most) == value)
            run++;
        size_t left = run;
        for (; left >= most; left -= most)
            put_step(s, most);
        put_step(s, (unsigned)left);
    }
}

/* As runs, or as they are where that takes less: then the glyph's offset says
 * so. Returns the bytes. `to` has room for two steps a pixel, all 0. */
static size_t encode(uint8_t *to, struct pel_font_glyph *glyph,
                     const uint8_t *level, int bits)
{
    const size_t pixels = (size_t)glyph->width * glyph->height;
    const unsigned most = (1u << bits) - 1;
    const size_t raw = (pixels * (size_t)bits + 7) / 8;
    struct steps s = {to, (size_t)bits, 0};
    put_runs(&s, level, pixels);
    const size_t size = (s.count * s.bits + 7) / 8;
    if (size <= raw)
        return size;
    memset(to, 0, size);
    s.count = 0;
    for (size_t i = 0; i < pixels; i++)
        put_step(&s, step_of(level[i], most));
    glyph->offset = PEL_FONT_RAW;
    return raw;
}

/* Rows in the asset's own form, malloc'ed. */
static struct rows rows_of(const struct font *font, const struct font_char *c,
                           struct pel_font_glyph *glyph)
{
    const uint8_t *bits = font->bits + c->offset;
    const size_t pixels = (size_t)c->width * (size_t)c->height;
    struct rows rows = {NULL, pel_font_glyph_size(glyph), glyph};
    rows.bits = calloc(font->steps ? 2 * pixels + 1 : rows.size + 1, 1);
    if (rows.bits && font->steps)
        rows.size = encode(rows.bits, glyph, bits, font->steps);
    else if (rows.bits)
        memcpy(rows.bits, bits, rows.size);
    return rows;
}

int font_index_of(const struct font *font, uint32_t code)
{
    for (size_t i = 0; i < font->count && i < 256; i++)
        if (font->chars[i].code == code)
            return (int)i;
    return -1;
}

/* Those whose glyphs are there, among the first 256. */
static uint16_t fill_pairs(struct pel_font_pair *pair, const struct font *font)
{
    uint16_t n = 0;
    for (size_t i = 0; i < font->pair_count && n < UINT16_MAX; i++) {
        const struct font_pair *p = &font->pairs[i];
        const int left = font_index_of(font, p->left);
        const int right = font_index_of(font, p->right);
        if (left >= 0 && right >= 0 && p->x >= -128 && p->x <= 127)
            pair[n++] = (struct pel_font_pair){(uint8_t)left, (uint8_t)right,
                                               (int8_t)p->x};
    }
    return n;
}

static struct pel_font_glyph glyph_of(const struct font_char *c)
{
    return (struct pel_font_glyph){.width = (uint8_t)c->width,
                                   .height = (uint8_t)c->height,
                                   .left = (int16_t)c->left,
                                   .top = (int16_t)c->top,
                                   .advance = (uint8_t)c->advance};
}

uint16_t font_fill_ranges(struct pel_font_range *range, const struct font *font)
{
    uint16_t n = 0;
    for (size_t i = 0; i < font->count; i++) {
        const uint32_t code = font->chars[i].code;
        if (n && code == range[n - 1].first + range[n - 1].count)
            range[n - 1].count++;
        else
            range[n++] = (struct pel_font_range){code, 1, (uint16_t)i};
    }
    return n;
}

uint16_t font_missing_of(const struct font *font)
{
    const long code[] = {font->missing, 0xFFFD, '?'};
    for (size_t k = 0; k < sizeof(code) / sizeof(*code); k++)
        for (size_t i = 0; i < font->count; i++)
            if ((long)font->chars[i].code == code[k])
                return (uint16_t)i;
    return PEL_FONT_NONE;
}

/* As high as the font above its baseline, and as wide as its widest glyph, less
 * a gap; the last code point of all, so that the order stays. */
bool font_add_box(struct font *font)
{
    uint8_t rows[FONT_SIZE_MAX][FONT_SIZE_MAX] = {{0}};
    struct font_char box = {.code = FONT_CODE_MAX, .width = 3};
    if (font_missing_of(font) != PEL_FONT_NONE)
        return true;
    for (size_t i = 0; i < font->count; i++)
        if (font->chars[i].advance - 1 > box.width)
            box.width = font->chars[i].advance - 1;
    box.advance = box.width + 1;
    box.top = box.height = font->ascent > 3 ? font->ascent : 3;
    for (int y = 0; y < box.height; y++)
        for (int x = 0; x < box.width; x++)
            if (x > 0 && x < box.width - 1 && y > 0 && y < box.height - 1)
                continue;
            else if (font->steps)
                rows[y][x] = 255;
            else
                rows[y][x / 8] |= (uint8_t)(0x80 >> x % 8);
    font->missing = FONT_CODE_MAX;
    return font_add(font, &box, rows[0], sizeof(rows[0]));
}

/* Glyphs and their rows; false when memory is short. */
static bool make_rows(struct pel_font_asset *asset, const struct font *font,
                      struct pel_font_glyph *glyph, struct rows *rows)
{
    size_t size = 1;
    bool done = true;
    for (size_t i = 0; i < font->count; i++) {
        glyph[i] = glyph_of(&font->chars[i]);
        rows[i] = rows_of(font, &font->chars[i], &glyph[i]);
        size += rows[i].size;
        done = done && rows[i].bits;
    }
    uint8_t *bits = done ? calloc(size, 1) : NULL;
    if (bits) {
        qsort(rows, font->count, sizeof *rows, by_bits);
        asset->size = (uint32_t)place_rows(bits, rows, font->count) + 1;
        asset->bits = bits;
    }
    for (size_t i = 0; i < font->count; i++)
        free(rows[i].bits);
    return bits != NULL;
}

bool font_count_legal(const struct font *font, const char *path)
{
    return font->count < PEL_FONT_NONE ||
           message_error_at(path, 0,
                            "has %zu glyphs: expected fewer than 65,535 "
                            "(pel import has --codes)",
                            font->count);
}

bool font_asset_make(struct pel_font_asset *asset, const struct font *font,
                     const char *path)
{
    const size_t n = font->count;
    *asset = (struct pel_font_asset){.magic = 0};
    if (!font_count_legal(font, path))
        return false;
    struct pel_font_range *range = malloc((n + 1) * sizeof *range);
    struct pel_font_glyph *glyph = malloc((n + 1) * sizeof *glyph);
    struct pel_font_pair *pair = malloc((font->pair_count + 1) * sizeof *pair);
    struct rows *rows = malloc((n + 1) * sizeof *rows);
    *asset = (struct pel_font_asset){.magic = PEL_FONT_MAGIC,
                                     .version = PEL_FONT_VERSION,
                                     .ascent = (uint8_t)font->ascent,
                                     .descent = (uint8_t)font->descent,
                                     .glyphs = (uint16_t)n,
                                     .missing = font_missing_of(font),
                                     .range = range,
                                     .glyph = glyph,
                                     .pair = pair};
    const bool done =
        range && glyph && pair && rows && make_rows(asset, font, glyph, rows);
    if (done) {
        asset->ranges = font_fill_ranges(range, font);
        asset->pairs = fill_pairs(pair, font);
        asset->kind = font->steps == 2   ? &pel_font_smooth_2
                      : font->steps == 4 ? &pel_font_smooth
                      : font->steps      ? &pel_font_smooth_8
                                         : NULL;
    } else
        font_asset_free(asset);
    free(rows);
    return done || message_error("out of memory");
}

/* The font of pel's own texts is a part of the program, a text with a 0 behind
 * it. Its name is global, since -flto may put it into another file than the
 * function below. WebAssembly parts data by symbols. */
#ifdef __wasm__
#define FONT_SECTION ".section .rodata.f,\"\",@\n.type builtin_font,@object\n"
#define FONT_END ".Lend:\n.size builtin_font, .Lend - builtin_font\n"
#else
#define FONT_SECTION ".section .rodata\n"
#define FONT_END ".text\n"
#endif
__asm__(FONT_SECTION ".globl builtin_font\n"
                     "builtin_font: .incbin \"sim/scenes/fixed_6x13.bdf\"\n"
                     ".byte 0\n" FONT_END);
extern const char builtin_font[];

bool font_asset_builtin(struct pel_font_asset *asset)
{
    struct font font = {.missing = -1};
    struct font_file file = {.path = "builtin:6x13",
                             .size = strlen(builtin_font)};
    file.data = malloc(file.size + 1); /* the parser cuts it into words */
    if (!file.data)
        return message_error("out of memory");
    memcpy(file.data, builtin_font, file.size + 1);
    const bool done = font_parse_bdf(&font, &file) &&
                      font_asset_make(asset, &font, file.path);
    free(file.data);
    font_free(&font);
    return done;
}

void font_asset_free(struct pel_font_asset *asset)
{
    free((void *)(uintptr_t)asset->range);
    free((void *)(uintptr_t)asset->glyph);
    free((void *)(uintptr_t)asset->bits);
    free((void *)(uintptr_t)asset->pair);
    *asset = (struct pel_font_asset){.magic = 0};
}
