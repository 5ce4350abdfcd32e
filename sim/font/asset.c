#include "sim/font/asset.h"

#include <stdlib.h>
#include <string.h>

#include "sim/cli/message.h"

/* The arrays while they are made. */
struct arrays {
    struct pel_font_range *range;
    struct pel_font_glyph *glyph;
    uint8_t *bits;
};

struct rows {
    const uint8_t *bits;
    size_t size, glyph;
};

static int by_bits(const void *a, const void *b)
{
    const struct rows *x = a, *y = b;
    if (x->size != y->size)
        return x->size < y->size ? -1 : 1;
    int order = x->size ? memcmp(x->bits, y->bits, x->size) : 0;
    return order ? order : (x->glyph > y->glyph) - (x->glyph < y->glyph);
}

/* Stores rows one behind the other, equal ones once; returns their bytes. */
static size_t place_rows(const struct arrays *to, const struct rows *rows,
                         size_t count)
{
    const struct rows *last = NULL;
    size_t size = 0;
    for (size_t i = 0; i < count; i++, last = rows++) {
        bool same = last && last->size == rows->size &&
                    memcmp(last->bits, rows->bits, rows->size) == 0;
        if (!same) {
            memcpy(to->bits + size, rows->bits, rows->size);
            size += rows->size;
        }
        to->glyph[rows->glyph].offset = (uint32_t)(size - rows->size);
    }
    return size;
}

static void fill_glyphs(const struct arrays *to, const struct font *font,
                        struct rows *rows)
{
    for (size_t i = 0; i < font->count; i++) {
        const struct font_char *c = &font->chars[i];
        struct pel_font_glyph *g = &to->glyph[i];
        g->width = (uint8_t)c->width;
        g->height = (uint8_t)c->height;
        g->left = (int8_t)c->left;
        g->top = (int8_t)c->top;
        g->advance = (uint8_t)c->advance;
        rows[i] =
            (struct rows){font->bits + c->offset, pel_font_glyph_size(g), i};
    }
}

static uint16_t fill_ranges(const struct arrays *to, const struct font *font)
{
    uint16_t n = 0;
    for (size_t i = 0; i < font->count; i++) {
        const uint32_t code = font->chars[i].code;
        struct pel_font_range *last = n ? &to->range[n - 1] : NULL;
        if (last && code == last->first + last->count)
            last->count++;
        else
            to->range[n++] = (struct pel_font_range){code, 1, (uint16_t)i};
    }
    return n;
}

/* The glyph of the font's code point for others, of U+FFFD, or of `?`. */
static uint16_t missing_of(const struct font *font)
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
    uint8_t rows[FONT_SIZE_MAX][(FONT_SIZE_MAX + 7) / 8] = {{0}};
    struct font_char box = {.code = FONT_CODE_MAX, .width = 3};
    if (missing_of(font) != PEL_FONT_NONE)
        return true;
    for (size_t i = 0; i < font->count; i++)
        if (font->chars[i].advance - 1 > box.width)
            box.width = font->chars[i].advance - 1;
    box.advance = box.width + 1;
    box.top = box.height = font->ascent > 3 ? font->ascent : 3;
    for (int y = 0; y < box.height; y++)
        for (int x = 0; x < box.width; x++)
            if (x == 0 || x == box.width - 1 || y == 0 || y == box.height - 1)
                rows[y][x / 8] |= (uint8_t)(0x80 >> x % 8);
    font->missing = FONT_CODE_MAX;
    return font_add(font, &box, rows[0], sizeof(rows[0]));
}

bool font_asset_make(struct pel_font_asset *asset, const struct font *font,
                     const char *path)
{
    const size_t n = font->count;
    *asset = (struct pel_font_asset){.magic = 0};
    if (n >= PEL_FONT_NONE)
        return message_error_at(path, 0,
                                "has %zu glyphs: expected fewer than 65,535 "
                                "(pel import has --codes)",
                                n);
    const struct arrays to = {malloc((n + 1) * sizeof(*to.range)),
                              calloc(n + 1, sizeof(*to.glyph)),
                              calloc(font->size + 1, 1)};
    struct rows *rows = malloc((n + 1) * sizeof(*rows));
    asset->range = to.range;
    asset->glyph = to.glyph;
    asset->bits = to.bits;
    bool done = to.range && to.glyph && to.bits && rows;
    if (done) {
        asset->magic = PEL_FONT_MAGIC;
        asset->version = PEL_FONT_VERSION;
        asset->ascent = (uint8_t)font->ascent;
        asset->descent = (uint8_t)font->descent;
        fill_glyphs(&to, font, rows);
        qsort(rows, n, sizeof(*rows), by_bits);
        asset->size = (uint32_t)place_rows(&to, rows, n) + 1;
        asset->ranges = fill_ranges(&to, font);
        asset->glyphs = (uint16_t)n;
        asset->missing = missing_of(font);
    } else
        font_asset_free(asset);
    free(rows);
    return done || message_error("out of memory");
}

/* The font of pel's own texts is a part of the program. */
__asm__(".section .rodata\n"
        "builtin_font: .incbin \"sim/scenes/fixed_6x13.bdf\"\n"
        "builtin_font_end: .byte 0\n"
        ".text\n");
extern const char builtin_font[], builtin_font_end[];

bool font_asset_builtin(struct pel_font_asset *asset)
{
    struct font font = {.missing = -1};
    struct font_file file = {.path = "builtin:6x13",
                             .size = (size_t)(builtin_font_end - builtin_font)};
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
    *asset = (struct pel_font_asset){.magic = 0};
}
