#include "sim/font/font.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/text_line.h"
#include "sim/cli/list.h"
#include "sim/cli/message.h"

enum { FILE_MAX = 64 << 20 };

static bool read_stream(struct font_file *file, FILE *stream)
{
    char chunk[1 << 16];
    size_t size = 0, got = 1;
    FILE *memory = open_memstream(&file->data, &file->size);
    while (memory && got > 0 && size <= FILE_MAX) {
        got = fread(chunk, 1, sizeof chunk, stream);
        size += fwrite(chunk, 1, got, memory);
    }
    const bool failed = !memory || ferror(memory);
    if ((memory && fclose(memory) != 0) || failed)
        return message_error_at(file->path, 0, "out of memory");
    if (size > FILE_MAX)
        return message_error_at(file->path, 0, "over 64 MB: expected a font");
    return !ferror(stream) ||
           message_error_at(file->path, 0, "cannot be read: %s",
                            strerror(errno));
}

static bool read_file(struct font_file *file)
{
    FILE *stream = file_open(file->path);
    if (!stream)
        return false;
    bool done = read_stream(file, stream);
    file_close(stream);
    return done;
}

static bool begins(const struct font_file *file, const char *bytes, size_t n)
{
    return file->size >= n && memcmp(file->data, bytes, n) == 0;
}

static bool parse(struct font *font, const struct font_file *file)
{
    if (begins(file, "STARTFONT", 9))
        return font_parse_bdf(font, file);
    if (begins(file, "\x36\x04", 2) || begins(file, "\x72\xB5\x4A\x86", 4))
        return font_parse_psf(font, file);
    if (begins(file, "\x1F\x8B", 2))
        return message_error_at(
            file->path, 0,
            "is compressed: expected what `gzip -d` makes of it");
    return message_error_at(file->path, 0,
                            "is no font: expected a BDF or PSF file");
}

static bool parse_behind_mark(struct font *font, const struct font_file *file)
{
    const size_t mark = byte_order_mark(file->data);
    const struct font_file rest = {file->path, file->data + mark,
                                   file->size - mark};
    return parse(font, &rest);
}

static int by_code(const void *a, const void *b)
{
    const struct font_char *x = a, *y = b;
    return (x->code > y->code) - (x->code < y->code);
}

static bool sort(struct font *font, const char *path)
{
    if (font->count == 0)
        return message_error_at(path, 0,
                                "has no glyph with a code point: expected a "
                                "font encoded in Unicode");
    qsort(font->chars, font->count, sizeof(*font->chars), by_code);
    for (size_t i = 1; i < font->count; i++)
        if (font->chars[i - 1].code == font->chars[i].code)
            return message_error_at(path, 0,
                                    "has two glyphs of U+%04X: expected one",
                                    (unsigned)font->chars[i].code);
    return true;
}

bool font_load(struct font *font, const char *path)
{
    struct font_file file = {.path = path};
    *font = (struct font){.missing = -1};
    bool done =
        read_file(&file) && parse_behind_mark(font, &file) && sort(font, path);
    free(file.data);
    if (!done)
        font_free(font);
    return done;
}

void font_free(struct font *font)
{
    free(font->chars);
    free(font->bits);
    *font = (struct font){.missing = -1};
}

static bool bit_at(const uint8_t *row, int x)
{
    return row[x / 8] >> (7 - x % 8) & 1;
}

static bool column_empty(const struct font_char *c, const uint8_t *rows,
                         size_t stride, int x)
{
    for (int y = 0; y < c->height; y++)
        if (bit_at(rows + (size_t)y * stride, x))
            return false;
    return true;
}

static bool row_empty(const struct font_char *c, const uint8_t *row)
{
    for (int x = 0; x < c->width; x++)
        if (bit_at(row, x))
            return false;
    return true;
}

/* The glyph without its empty margins, as far as left and top stay in the range
 * of an asset; the column and row where it begins. */
static struct font_char trimmed(const struct font_char *c, const uint8_t *rows,
                                size_t stride, int *x, int *y)
{
    int x1 = c->width, y1 = c->height;
    struct font_char t = *c;
    *x = *y = 0;
    while (*y < y1 && c->top - *y > -128 &&
           row_empty(c, rows + (size_t)*y * stride))
        ++*y;
    while (y1 > *y && row_empty(c, rows + (size_t)(y1 - 1) * stride))
        y1--;
    if (*y == y1) /* all empty */
        *x = x1;
    while (*x < x1 && c->left + *x < 127 && column_empty(c, rows, stride, *x))
        ++*x;
    while (x1 > *x && column_empty(c, rows, stride, x1 - 1))
        x1--;
    t.width = x1 - *x;
    t.height = y1 - *y;
    t.left = t.width ? c->left + *x : 0;
    t.top = t.width ? c->top - *y : 0;
    return t;
}

bool font_add_alias(struct font *font, uint32_t code)
{
    struct font_char c = font->chars[font->count - 1];
    c.code = code;
    return list_add(&font->chars, &font->count, &c, sizeof c);
}

static bool grow_bits(struct font *font, size_t bytes)
{
    uint8_t *bits = realloc(font->bits, font->size + bytes + 1);
    if (!bits)
        return message_error("out of memory");
    memset(bits + font->size, 0, bytes + 1);
    font->bits = bits;
    return true;
}

bool font_add(struct font *font, const struct font_char *glyph,
              const uint8_t *rows, size_t stride)
{
    int x0, y0;
    struct font_char c = trimmed(glyph, rows, stride, &x0, &y0);
    const size_t row = ((size_t)c.width + 7) / 8;
    const size_t bytes = row * (size_t)c.height;
    c.offset = font->size;
    if (!grow_bits(font, bytes) ||
        !list_add(&font->chars, &font->count, &c, sizeof c))
        return false;
    for (int y = 0; y < c.height; y++)
        for (int x = 0; x < c.width; x++)
            if (bit_at(rows + (size_t)(y0 + y) * stride, x0 + x))
                font->bits[font->size + (size_t)y * row + (size_t)x / 8] |=
                    (uint8_t)(0x80 >> x % 8);
    font->size += bytes;
    return true;
}
