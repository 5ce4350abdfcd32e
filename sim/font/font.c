#include "sim/font/font.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/child.h"
#include "sim/cli/list.h"
#include "sim/cli/message.h"
#include "sim/cli/text_line.h"

static bool read_file(struct font_file *file)
{
    file->data = file_read(file->path, &file->size);
    return file->data || file_refuse(file->path);
}

static bool begins(const struct font_file *file, const char *bytes, size_t n)
{
    return file->size >= n && memcmp(file->data, bytes, n) == 0;
}

/* Behind a byte order mark. */
static bool parse(struct font *font, const struct font_file *whole)
{
    struct font_file file = *whole;
    const size_t mark = byte_order_mark(whole->data);
    file.data += mark;
    file.size -= mark;
    if (begins(&file, "STARTFONT", 9))
        return font_parse_bdf(font, &file);
    if (begins(&file, "\x36\x04", 2) || begins(&file, "\x72\xB5\x4A\x86", 4))
        return font_parse_psf(font, &file);
    return font_parse_other(font, &file);
}

static int by_code(const void *a, const void *b)
{
    const struct font_char *x = a, *y = b;
    const int places = (x->offset > y->offset) - (x->offset < y->offset);
    return x->code == y->code ? places : x->code > y->code ? 1 : -1;
}

/* By code point, each once. */
static bool sort(struct font *font, const char *path)
{
    size_t n = 1;
    if (font->count == 0)
        return message_error_at(path, 0,
                                "has no glyph with a code point that is "
                                "wanted: expected a font of characters");
    qsort(font->chars, font->count, sizeof(*font->chars), by_code);
    for (size_t i = 1; i < font->count; i++)
        if (font->chars[n - 1].code != font->chars[i].code)
            font->chars[n++] = font->chars[i];
    if (n < font->count)
        message_error_at(path, 0,
                         "has a second glyph of %zu characters, of which the "
                         "first is taken",
                         font->count - n);
    font->count = n;
    return true;
}

/* Writes the font to the parent. */
static bool put_font(const void *what, FILE *out)
{
    struct font_file file = *(const struct font_file *)what;
    struct font font = {.missing = -1};
    if (!read_file(&file) ||
        (begins(&file, "\x1F\x8B", 2) && !font_unpack(&file)) ||
        !parse(&font, &file) || !sort(&font, file.path))
        return false;
    if (file.options.bits > 1 && !font.steps)
        return message_error_at(file.path, 0,
                                "has pictures of glyphs, no outlines: expected "
                                "no --bits %d",
                                file.options.bits);
    if (file.options.outline && !font.em)
        return message_error_at(file.path, 0,
                                "has pictures of glyphs, no outlines: expected "
                                "no --outline");
    fwrite(&font, sizeof font, 1, out);
    child_put(out, font.chars, font.count * sizeof *font.chars);
    child_put(out, font.bits, font.size);
    child_put(out, font.pairs, font.pair_count * sizeof *font.pairs);
    return true;
}

/* A list has room for a power of two. */
static bool make_room(struct font *font)
{
    size_t room = 1;
    while (room < font->count)
        room *= 2;
    struct font_char *chars = realloc(font->chars, room * sizeof *chars);
    font->chars = chars ? chars : font->chars;
    return chars || message_error("out of memory");
}

bool font_load(struct font *font, const char *path,
               const struct font_options *options)
{
    size_t size;
    const struct font_file file = {.path = path, .options = *options};
    FILE *in = child_run(path, put_font, &file);
    bool done = in && fread(font, sizeof *font, 1, in) == 1;
    if (!done)
        *font = (struct font){.missing = -1};
    font->chars = done ? child_get(in, &size, &done) : NULL;
    font->bits = done ? child_get(in, &size, &done) : NULL;
    font->pairs = done ? child_get(in, &size, &done) : NULL;
    if (in)
        fclose(in);
    if (done)
        done = make_room(font);
    if (!done)
        font_free(font);
    return done;
}

void font_free(struct font *font)
{
    free(font->chars);
    free(font->bits);
    free(font->pairs);
    *font = (struct font){.missing = -1};
}

/* Rows as files have them. */
struct rows {
    const uint8_t *at;
    size_t stride;
    bool is_coverage; /* a byte a pixel */
};

static uint8_t level_at(const struct rows *rows, int x, int y)
{
    const uint8_t *row = rows->at + (size_t)y * rows->stride;
    return (uint8_t)(rows->is_coverage ? row[x]
                                       : row[x / 8] >> (7 - x % 8) & 1);
}

/* The glyph without its empty margins; *x0 and *y0 are the column and row where
 * it begins. */
static struct font_char trimmed(const struct font_char *c,
                                const struct rows *rows, int *x0, int *y0)
{
    int x1 = 0, y1 = 0;
    struct font_char t = *c;
    *x0 = c->width;
    *y0 = c->height;
    for (int y = 0; y < c->height; y++)
        for (int x = 0; x < c->width; x++)
            if (level_at(rows, x, y)) {
                *x0 = x < *x0 ? x : *x0;
                *y0 = y < *y0 ? y : *y0;
                x1 = x >= x1 ? x + 1 : x1;
                y1 = y + 1;
            }
    t.width = x1 ? x1 - *x0 : 0;
    t.height = x1 ? y1 - *y0 : 0;
    t.left = x1 ? c->left + *x0 : 0;
    t.top = x1 ? c->top - *y0 : 0;
    return t;
}

bool font_add_alias(struct font *font, uint32_t code)
{
    struct font_char c = font->chars[font->count - 1];
    c.code = code;
    return list_add(&font->chars, &font->count, &c, sizeof c);
}

bool font_add(struct font *font, const struct font_char *glyph,
              const uint8_t *bits, size_t stride)
{
    const struct rows rows = {bits, stride, font->steps > 0};
    int x0, y0;
    struct font_char c = trimmed(glyph, &rows, &x0, &y0);
    const size_t row =
        font->steps ? (size_t)c.width : ((size_t)c.width + 7) / 8;
    const size_t bytes = row * (size_t)c.height;
    c.offset = font->size;
    uint8_t *to = realloc(font->bits, font->size + bytes + 1);
    if (!to)
        return message_error("out of memory");
    font->bits = to;
    to += font->size;
    font->size += bytes;
    memset(to, 0, bytes + 1);
    for (int y = 0; y < c.height; y++, to += row)
        for (int x = 0; x < c.width; x++) {
            const uint8_t level = level_at(&rows, x0 + x, y0 + y);
            if (font->steps)
                to[x] = level;
            else if (level)
                to[x / 8] |= (uint8_t)(0x80 >> x % 8);
        }
    return list_add(&font->chars, &font->count, &c, sizeof c);
}
