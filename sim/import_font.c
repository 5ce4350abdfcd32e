#include "import.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "core/asset/font_asset.h"
#include "font.h"
#include "import_text.h"
#include "message.h"

/* FIRST[-LAST] at *text, and moves it to what follows; numbers as in C. */
static bool next_range(const char **text, unsigned long range[2])
{
    const char *p = *text;
    for (int i = 0; i < 2; i++) {
        char *end;
        if (!isdigit((unsigned char)*p))
            return false;
        range[i] = strtoul(p, &end, 0);
        p = end;
        if (i == 0 && *p != '-')
            range[++i] = range[0];
        else if (i == 0)
            p++;
    }
    if (range[0] > range[1] || range[1] > FONT_CODE_MAX)
        return false;
    *text = p;
    return true;
}

bool import_codes_legal(const char *codes)
{
    unsigned long range[2];
    const char *p = codes;
    bool legal = next_range(&p, range);
    while (legal && *p == ',') {
        p++;
        legal = next_range(&p, range);
    }
    return (legal && *p == '\0') ||
           message_error("--codes is '%s'; code points such as 32-126,0x20AC "
                         "would be right",
                         codes);
}

static bool is_wanted(const char *codes, uint32_t code)
{
    unsigned long range[2];
    while (next_range(&codes, range)) {
        if (code >= range[0] && code <= range[1])
            return true;
        codes += *codes == ',';
    }
    return false;
}

/* Drops the glyphs that are not asked for; they stay in order. */
static bool keep_codes(struct font *font, const char *path, const char *codes)
{
    size_t kept = 0;
    for (size_t i = 0; i < font->count; i++)
        if (is_wanted(codes, font->chars[i].code))
            font->chars[kept++] = font->chars[i];
    font->count = kept;
    return kept > 0 || message_error_at(path, 0,
                                        "has no glyph of --codes %s; code "
                                        "points that it has would be right",
                                        codes);
}

static size_t bytes_of(const struct font_char *c)
{
    return ((size_t)c->width + 7) / 8 * (size_t)c->height;
}

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

static void place(struct font *font, const struct rows *rows, uint8_t *bits)
{
    const struct rows *last = NULL;
    size_t size = 0;
    for (size_t i = 0; i < font->count; i++, last = rows++) {
        bool same = last && last->size == rows->size &&
                    memcmp(last->bits, rows->bits, rows->size) == 0;
        if (!same) {
            memcpy(bits + size, rows->bits, rows->size);
            size += rows->size;
        }
        font->chars[rows->glyph].offset = size - rows->size;
    }
    font->size = size;
}

/* Puts the bits of the kept glyphs one behind the other, equal ones once. */
static bool pack_bits(struct font *font)
{
    uint8_t *bits = malloc(font->size + 1);
    struct rows *rows = malloc(font->count * sizeof(*rows));
    bool done = bits && rows;
    for (size_t i = 0; done && i < font->count; i++)
        rows[i] = (struct rows){font->bits + font->chars[i].offset,
                                bytes_of(&font->chars[i]), i};
    if (done) {
        qsort(rows, font->count, sizeof(*rows), by_bits);
        place(font, rows, bits);
        free(font->bits);
        font->bits = bits;
    } else
        free(bits);
    free(rows);
    return done || message_error("out of memory");
}

static void write_bits(struct import_text *text, const char *name,
                       const struct font *font)
{
    const struct import_array array = {"uint8_t", "bits",
                                       (uint32_t)font->size + 1, 1};
    const long zero = 0;
    import_array_begin(text, name, &array);
    for (size_t i = 0; i < font->size; i++) {
        const long value = font->bits[i];
        import_array_item(text, &value, 1);
    }
    import_array_item(text, &zero, 1);
    import_array_end(text);
}

static void write_glyphs(struct import_text *text, const char *name,
                         const struct font *font)
{
    const struct import_array array = {"struct pel_font_glyph", "glyphs",
                                       (uint32_t)font->count, 1};
    import_array_begin(text, name, &array);
    for (size_t i = 0; i < font->count; i++) {
        const struct font_char *c = &font->chars[i];
        const long value[] = {(long)c->offset, c->width, c->height,
                              c->left,         c->top,   c->advance};
        import_array_item(text, value, 6);
    }
    import_array_end(text);
}

/* First glyph of the range that follows the one that begins at glyph i. */
static size_t range_end(const struct font *font, size_t i)
{
    for (i++; i < font->count; i++)
        if (font->chars[i].code != font->chars[i - 1].code + 1)
            break;
    return i;
}

static uint32_t count_ranges(const struct font *font)
{
    uint32_t n = 0;
    for (size_t i = 0; i < font->count; i = range_end(font, i))
        n++;
    return n;
}

static void write_ranges(struct import_text *text, const char *name,
                         const struct font *font)
{
    const struct import_array array = {"struct pel_font_range", "ranges",
                                       count_ranges(font), 1};
    import_array_begin(text, name, &array);
    for (size_t i = 0, end; i < font->count; i = end) {
        end = range_end(font, i);
        const long value[] = {(long)font->chars[i].code, (long)(end - i),
                              (long)i};
        import_array_item(text, value, 3);
    }
    import_array_end(text);
}

/* The glyph of the code point for others, of U+FFFD, or of a question mark. */
static long missing_of(const struct font *font)
{
    const long code[] = {font->missing, 0xFFFD, '?'};
    for (size_t k = 0; k < sizeof(code) / sizeof(*code); k++)
        for (size_t i = 0; i < font->count; i++)
            if ((long)font->chars[i].code == code[k])
                return (long)i;
    return PEL_FONT_NONE;
}

static void write_asset(struct import_text *text, const char *name,
                        const struct font *font)
{
    FILE *out = text->output.stream;
    write_bits(text, name, font);
    write_glyphs(text, name, font);
    write_ranges(text, name, font);
    fprintf(out, "\nextern const struct pel_font_asset %s;\n", name);
    fprintf(out, "const struct pel_font_asset %s = {\n", name);
    fprintf(out, "    PEL_FONT_MAGIC,\n    PEL_FONT_VERSION,\n");
    fprintf(out, "    %d, /* px above the baseline */\n", font->ascent);
    fprintf(out, "    %d, /* px below it */\n", font->descent);
    fprintf(out, "    %lu,\n    %lu,\n    %ld, /* of what is missing */\n",
            (unsigned long)count_ranges(font), (unsigned long)font->count,
            missing_of(font));
    fprintf(out, "    %lu,\n", (unsigned long)font->size + 1);
    fprintf(out, "    %s_ranges,\n    %s_glyphs,\n    %s_bits,\n};\n", name,
            name, name);
}

bool import_font(const struct import_options *options)
{
    struct font font;
    struct import_text text;
    if (!font_load(&font, options->source))
        return false;
    bool done =
        !options->codes || keep_codes(&font, options->source, options->codes);
    if (done && font.count >= PEL_FONT_NONE)
        done = message_error_at(options->source, 0,
                                "has %zu glyphs; fewer than 65,535, with "
                                "--codes FIRST-LAST, would be right",
                                font.count);
    done = done && pack_bits(&font) &&
           import_text_open(&text, options->output, options->source,
                            "core/asset/font_asset.h");
    if (done) {
        write_asset(&text, options->name, &font);
        done = output_commit(&text.output);
    }
    font_free(&font);
    return done;
}
