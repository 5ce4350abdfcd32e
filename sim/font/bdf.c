/* Glyph Bitmap Distribution Format, Adobe Technical Note 5005 (versions 2.1 and
 * 2.2). Vertical writing is read over. */
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "sim/cli/arguments.h"
#include "sim/cli/message.h"
#include "sim/font/font.h"

struct glyph {
    int code;    /* -1: none in the font's encoding */
    int advance; /* -1: not given */
    int box[4];
    bool has_box;
};

struct bdf {
    struct font *font;
    const char *path;
    char *next, *end; /* of the file */
    long line;
    char *word; /* the line's first */
    char *rest; /* and what follows, without blanks at both ends */
    const char *registry, *encoding;
    struct glyph all; /* what glyphs are that do not say it themselves */
    int ascent, descent, missing, chars; /* -1: not given */
    int read;                            /* glyphs */
};

static bool is(const struct bdf *b, const char *word)
{
    return strcmp(b->word, word) == 0;
}

/* The next line that is not blank and no comment. Zero bytes are put behind its
 * parts. */
static bool next_line(struct bdf *b, const char *wanted)
{
    do {
        if (b->next >= b->end)
            return ERROR_AT(b, "the file ends here: expected %s", wanted);
        char *stop = memchr(b->next, '\n', (size_t)(b->end - b->next));
        stop = stop ? stop : b->end;
        b->word = b->next;
        b->next = stop + 1;
        b->line++;
        while (stop > b->word && strchr(" \t\r", stop[-1]))
            stop--;
        *stop = '\0';
        b->rest = b->word + strcspn(b->word, " \t");
        if (*b->rest)
            *b->rest++ = '\0';
        b->rest += strspn(b->rest, " \t");
    } while (!*b->word || is(b, "COMMENT"));
    return true;
}

/* Exactly n whole numbers after the word. */
static bool numbers(struct bdf *b, int n, int *value)
{
    char *end = b->rest;
    bool right = true;
    for (int i = 0; right && i < n; i++) {
        const char *start = end;
        const long v = strtol(start, &end, 10);
        right = end > start && strchr(" \t", *end) && v >= -32768 &&
                v <= FONT_CODE_MAX;
        value[i] = (int)v;
    }
    return (right && end[strspn(end, " \t")] == '\0') ||
           ERROR_AT(b, "'%s %s': expected %s with %d whole number%s", b->word,
                    b->rest, b->word, n, n > 1 ? "s" : "");
}

static bool number_in(struct bdf *b, int lo, int hi, int *value)
{
    return numbers(b, 1, value) && ((*value >= lo && *value <= hi) ||
                                    ERROR_AT(b, "%s is %d: expected %d to %d",
                                             b->word, *value, lo, hi));
}

/* "name" or name. */
static const char *unquoted(char *text)
{
    const size_t n = strlen(text);
    const bool quoted = n > 1 && text[0] == '"' && text[n - 1] == '"';
    if (quoted)
        text[n - 1] = '\0';
    return text + quoted;
}

/* Code points are read as Unicode: is that what the font has? */
static bool check_charset(struct bdf *b)
{
    const bool latin1 = strcasecmp(b->registry, "ISO8859") == 0 &&
                        strcmp(b->encoding, "1") == 0;
    return !*b->registry || latin1 ||
           strcasecmp(b->registry, "ISO10646") == 0 ||
           ERROR_AT(b,
                    "the font is encoded in %s-%s: expected ISO10646-1 "
                    "(Unicode) or ISO8859-1",
                    b->registry, b->encoding);
}

static bool read_properties(struct bdf *b)
{
    int count;
    bool right = number_in(b, 0, 10000, &count);
    while (right && next_line(b, "ENDPROPERTIES")) {
        if (is(b, "ENDPROPERTIES"))
            return check_charset(b);
        if (is(b, "FONT_ASCENT"))
            right = number_in(b, 0, FONT_SIZE_MAX, &b->ascent);
        else if (is(b, "FONT_DESCENT"))
            right = number_in(b, 0, FONT_SIZE_MAX, &b->descent);
        else if (is(b, "DEFAULT_CHAR"))
            right = number_in(b, 0, FONT_CODE_MAX, &b->missing);
        else if (is(b, "CHARSET_REGISTRY"))
            b->registry = unquoted(b->rest);
        else if (is(b, "CHARSET_ENCODING"))
            b->encoding = unquoted(b->rest);
        else if (is(b, "STARTCHAR") || is(b, "CHARS"))
            right = ERROR_AT(
                b, "%s among the properties: expected ENDPROPERTIES before it",
                b->word);
    }
    return false;
}

static bool read_advance(struct bdf *b, struct glyph *g)
{
    int v[2];
    if (!numbers(b, 2, v))
        return false;
    g->advance = v[0];
    return (v[0] >= 0 && v[0] <= FONT_SIZE_MAX && v[1] == 0) ||
           ERROR_AT(b, "DWIDTH is %d %d: expected 0 to %d, and 0", v[0], v[1],
                    FONT_SIZE_MAX);
}

static bool read_box(struct bdf *b, struct glyph *g)
{
    const int *box = g->box;
    g->has_box = numbers(b, 4, g->box);
    return g->has_box &&
           ((box[0] >= 0 && box[0] <= FONT_SIZE_MAX && box[1] >= 0 &&
             box[1] <= FONT_SIZE_MAX && box[2] >= -128 && box[2] <= 127 &&
             box[1] + box[3] >= -128 && box[1] + box[3] <= 127) ||
            ERROR_AT(b,
                     "%s is %s: expected a width and height of 0 to %d, and a "
                     "place within -128 to 127 of the origin",
                     b->word, b->rest, FONT_SIZE_MAX));
}

/* ENCODING CODE, or ENCODING -1 with a code of the font's own. */
static bool read_encoding(struct bdf *b, struct glyph *g)
{
    int own[2];
    if (strncmp(b->rest, "-1", 2) == 0 && strpbrk(b->rest, " \t")) {
        g->code = -1;
        return numbers(b, 2, own);
    }
    return number_in(b, -1, FONT_CODE_MAX, &g->code);
}

/* The lines between STARTCHAR and BITMAP. */
static bool read_head(struct bdf *b, struct glyph *g)
{
    bool has_code = false, right = true;
    while (right && next_line(b, "BITMAP")) {
        if (is(b, "BITMAP")) {
            const char *lacks = !has_code          ? "ENCODING"
                                : !g->has_box      ? "BBX"
                                : g->advance == -1 ? "DWIDTH"
                                                   : NULL;
            return !lacks ||
                   ERROR_AT(b,
                            "the glyph has no %s: expected one before BITMAP",
                            lacks);
        }
        if (is(b, "ENCODING"))
            has_code = right = read_encoding(b, g);
        else if (is(b, "DWIDTH"))
            right = read_advance(b, g);
        else if (is(b, "BBX"))
            right = read_box(b, g);
        else if (choice_find("SWIDTH|SWIDTH1|DWIDTH1|VVECTOR|ATTRIBUTES",
                             b->word) < 0)
            right = ERROR_AT(
                b, "'%s' in a glyph: expected ENCODING, DWIDTH, BBX or BITMAP",
                b->word);
    }
    return false;
}

/* Bits right of the width are padding, whatever they are. */
static bool read_rows(struct bdf *b, int stride, int height, uint8_t *rows)
{
    for (int y = 0; y < height && stride > 0; y++) {
        if (!next_line(b, "a row of the glyph"))
            return false;
        const size_t digits = strspn(b->word, "0123456789abcdefABCDEF");
        if (digits != (size_t)(2 * stride) || b->word[digits] || *b->rest)
            return ERROR_AT(
                b, "'%s' as row %d of %d: expected %d hexadecimal digits",
                b->word, y + 1, height, 2 * stride);
        for (const char *c = b->word; *c; c += 2) {
            const char byte[3] = {c[0], c[1]};
            *rows++ = (uint8_t)strtoul(byte, NULL, 16);
        }
    }
    return next_line(b, "ENDCHAR") &&
           (is(b, "ENDCHAR") ||
            ERROR_AT(b, "'%s' after %d rows: expected ENDCHAR", b->word,
                     height));
}

static bool read_glyph(struct bdf *b)
{
    struct glyph g = b->all;
    uint8_t rows[FONT_SIZE_MAX * ((FONT_SIZE_MAX + 7) / 8)] = {0};
    if (!read_head(b, &g))
        return false;
    const int stride = (g.box[0] + 7) / 8;
    if (!read_rows(b, stride, g.box[1], rows))
        return false;
    b->read++;
    const struct font_char c = {
        .code = (uint32_t)g.code,
        .width = g.box[0],
        .height = g.box[1],
        .left = g.box[2],
        .top = g.box[1] + g.box[3],
        .advance = g.advance,
    };
    return g.code < 0 || font_add(b->font, &c, rows, (size_t)stride);
}

/* One line between the glyphs, and what belongs to it. */
static bool read_entry(struct bdf *b)
{
    if (is(b, "STARTCHAR"))
        return read_glyph(b);
    if (is(b, "STARTPROPERTIES"))
        return read_properties(b);
    if (is(b, "FONTBOUNDINGBOX"))
        return read_box(b, &b->all);
    if (is(b, "DWIDTH"))
        return read_advance(b, &b->all);
    if (is(b, "CHARS"))
        return number_in(b, 0, FONT_CODE_MAX, &b->chars);
    return choice_find("CONTENTVERSION|FONT|SIZE|METRICSSET|SWIDTH|SWIDTH1|"
                       "DWIDTH1|VVECTOR",
                       b->word) >= 0 ||
           ERROR_AT(b, "'%s' between glyphs: expected STARTCHAR or ENDFONT",
                    b->word);
}

/* The lines of a font without properties are as high as its box. */
static bool finish(struct bdf *b)
{
    const int *box = b->all.box;
    const int above = box[1] + box[3], below = -box[3];
    if (b->chars != b->read)
        return ERROR_AT(b, "%d glyphs: expected the %d that CHARS says",
                        b->read, b->chars);
    b->font->missing = b->missing;
    b->font->ascent = b->ascent >= 0 ? b->ascent : above > 0 ? above : 0;
    b->font->descent = b->descent >= 0 ? b->descent : below > 0 ? below : 0;
    return true;
}

bool font_parse_bdf(struct font *font, const struct font_file *file)
{
    struct bdf b = {
        .font = font,
        .path = file->path,
        .next = file->data,
        .end = file->data + file->size,
        .registry = "",
        .encoding = "",
        .all = {.code = -1, .advance = -1},
        .ascent = -1,
        .descent = -1,
        .missing = -1,
        .chars = -1,
    };
    if (!next_line(&b, "STARTFONT 2.1"))
        return false;
    if (!is(&b, "STARTFONT") || strncmp(b.rest, "2.", 2) != 0)
        return ERROR_AT(&b, "'%s %s': expected STARTFONT 2.1", b.word, b.rest);
    while (next_line(&b, "ENDFONT")) {
        if (is(&b, "ENDFONT"))
            return finish(&b);
        if (!read_entry(&b))
            return false;
    }
    return false;
}
