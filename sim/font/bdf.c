/* Glyph Bitmap Distribution Format, Adobe Technical Note 5005 (versions 2.1 and
 * 2.2). Vertical writing is read over. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/arguments.h"
#include "sim/cli/message.h"
#include "sim/font/charset.h"
#include "sim/font/font.h"

struct glyph {
    long code;   /* -1: none in the font's encoding */
    int advance; /* -1: not given */
    int box[4];
    bool has_box;
};

/* What is read in spite of it, and told in the end. */
enum odd {
    ODD_END,
    ODD_COUNT,
    ODD_HEIGHT,
    ODD_LINE,
    ODD_CODE,
    ODD_ADVANCE,
    ODD_BOX,
    ODD_ROWS,
    ODD_ROW,
    ODD_KINDS
};

static const char *const odd_names[ODD_KINDS] = {
    "missing ENDFONT",
    "missing or wrong CHARS",
    "FONT_ASCENT of 0",
    "lines that are not of the format",
    "glyphs without ENCODING",
    "glyphs without DWIDTH, or with one that goes up",
    "glyphs without BBX",
    "glyphs with more or fewer rows than high",
    "rows longer or shorter than wide",
};

struct bdf {
    struct font *font;
    const char *path;
    char *next, *end; /* of the file */
    long line;
    char *word; /* the line's first */
    char *rest; /* and what follows, without blanks at both ends */
    bool again; /* the line is to be read once more */
    const char *name, *registry, *encoding;
    const char *wanted_encoding;
    struct charset charset;
    bool has_charset;
    struct glyph all; /* what glyphs are that do not say it themselves */
    int ascent, descent, missing, chars; /* -1: not given */
    int read;                            /* glyphs */
    unsigned odd[ODD_KINDS];
};

static bool is(const struct bdf *b, const char *word)
{
    return strcmp(b->word, word) == 0;
}

/* The next line that is not blank and no comment; false at the end. Zero bytes
 * are put behind its parts. */
static bool next_line(struct bdf *b)
{
    if (b->again) {
        b->again = false;
        return true;
    }
    do {
        if (b->next >= b->end)
            return false;
        char *stop = memchr(b->next, '\n', (size_t)(b->end - b->next));
        stop = stop ? stop : b->end;
        b->word = b->next + strspn(b->next, " \t\r");
        b->next = stop + 1;
        b->line++;
        if (b->word > stop)
            b->word = stop;
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

static bool refuse_end(const struct bdf *b, const char *wanted)
{
    return ERROR_AT(b, "the file ends here: expected %s", wanted);
}

/* Whole numbers after the word, n at most; how many there are. */
static int numbers(struct bdf *b, int n, int *value)
{
    char *end = b->rest;
    int i = 0;
    for (; i < n; i++) {
        const char *start = end;
        const long v = strtol(start, &end, 10);
        if (end == start || !strchr(" \t", *end) || v < -FONT_CODE_MAX ||
            v > FONT_CODE_MAX)
            break;
        value[i] = (int)v;
    }
    if (i < n || end[strspn(end, " \t")])
        b->odd[ODD_LINE]++;
    return i;
}

/* What is no number in the range is as if it were not there. */
static void number(struct bdf *b, int lo, int hi, int *value)
{
    int v;
    if (numbers(b, 1, &v) < 1)
        return;
    if (v >= lo && v <= hi)
        *value = v;
    else
        b->odd[ODD_LINE]++;
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

/* Those that end without ENDPROPERTIES end where a glyph begins. */
static bool read_properties(struct bdf *b)
{
    while (next_line(b)) {
        if (is(b, "ENDPROPERTIES"))
            return true;
        if (is(b, "FONT_ASCENT"))
            number(b, 0, FONT_SIZE_MAX, &b->ascent);
        else if (is(b, "FONT_DESCENT"))
            number(b, 0, FONT_SIZE_MAX, &b->descent);
        else if (is(b, "DEFAULT_CHAR"))
            number(b, 0, FONT_CODE_MAX, &b->missing);
        else if (is(b, "CHARSET_REGISTRY"))
            b->registry = unquoted(b->rest);
        else if (is(b, "CHARSET_ENCODING"))
            b->encoding = unquoted(b->rest);
        else if (is(b, "STARTCHAR") || is(b, "CHARS")) {
            b->odd[ODD_LINE]++;
            b->again = true;
            return true;
        }
    }
    return refuse_end(b, "ENDPROPERTIES");
}

static bool read_advance(struct bdf *b, struct glyph *g)
{
    int v[2] = {0, 0};
    if (numbers(b, 2, v) < 1)
        return true;
    b->odd[ODD_ADVANCE] += v[1] != 0;
    g->advance = v[0];
    return (v[0] >= 0 && v[0] <= FONT_SIZE_MAX) ||
           ERROR_AT(b, "DWIDTH is %d: expected 0 to %d", v[0], FONT_SIZE_MAX);
}

static bool read_box(struct bdf *b, struct glyph *g)
{
    enum { MOST = FONT_SIZE_MAX };
    const int *box = g->box;
    g->has_box = numbers(b, 4, g->box) == 4;
    return (g->has_box && box[0] >= 0 && box[0] <= MOST && box[1] >= 0 &&
            box[1] <= MOST && box[2] >= -MOST && box[2] <= MOST &&
            box[3] >= -MOST && box[1] + box[3] <= MOST) ||
           ERROR_AT(b,
                    "%s is %s: expected a width and height of 0 to %d, and a "
                    "place within -%d to %d of the origin",
                    b->word, b->rest, MOST, MOST, MOST);
}

/* ENCODING CODE, or ENCODING -1 with a code of the font's own. */
static void read_encoding(struct bdf *b, struct glyph *g)
{
    int own[2] = {-1, -1};
    if (strncmp(b->rest, "-1", 2) == 0)
        numbers(b, strpbrk(b->rest, " \t") ? 2 : 1, own);
    else
        number(b, 0, FONT_CODE_MAX, &own[0]);
    g->code = own[0];
}

/* The lines between STARTCHAR and BITMAP. */
static bool read_head(struct bdf *b, struct glyph *g)
{
    bool has_code = false, right = true;
    while (right && next_line(b)) {
        if (is(b, "BITMAP")) {
            b->odd[ODD_CODE] += !has_code;
            b->odd[ODD_BOX] += !g->has_box;
            b->odd[ODD_ADVANCE] += g->advance < 0;
            return true;
        }
        if (is(b, "ENCODING")) {
            read_encoding(b, g);
            has_code = true;
        } else if (is(b, "DWIDTH"))
            right = read_advance(b, g);
        else if (is(b, "BBX"))
            right = read_box(b, g);
        else if (choice_find("SWIDTH|SWIDTH1|DWIDTH1|VVECTOR|ATTRIBUTES",
                             b->word) < 0)
            b->odd[ODD_LINE]++;
    }
    return right && refuse_end(b, "BITMAP");
}

static uint8_t digit_of(char c)
{
    return (uint8_t)(c <= '9' ? c - '0' : (c | 0x20) - 'a' + 10);
}

/* Bits right of the width are padding, whatever they are. */
static void read_row(struct bdf *b, size_t stride, uint8_t *row)
{
    const size_t digits = strspn(b->word, "0123456789abcdefABCDEF");
    for (size_t i = 0; i < digits && i < 2 * stride; i++)
        row[i / 2] |= (uint8_t)(digit_of(b->word[i]) << (i % 2 ? 0 : 4));
    b->odd[ODD_ROW] += digits != 2 * stride || b->word[digits] || *b->rest;
}

static bool read_rows(struct bdf *b, size_t stride, int height, uint8_t *rows)
{
    for (int y = 0; next_line(b); y++) {
        const bool ended = is(b, "ENDCHAR");
        b->again = is(b, "STARTCHAR") || is(b, "ENDFONT");
        if (ended || b->again) {
            b->odd[ODD_ROWS] += b->again || (stride > 0 && y != height);
            return true;
        }
        if (y < height && stride > 0)
            read_row(b, stride, rows + (size_t)y * stride);
    }
    return refuse_end(b, "ENDCHAR");
}

/* The encoding that is wanted, or that of the font's properties, or that of its
 * name. */
static bool find_charset(struct bdf *b)
{
    char name[128] = "";
    if (b->wanted_encoding)
        snprintf(name, sizeof name, "%s", b->wanted_encoding);
    else if (*b->registry)
        snprintf(name, sizeof name, "%s-%s", b->registry, b->encoding);
    else
        snprintf(name, sizeof name, "%s", charset_of_name(b->name));
    b->has_charset = charset_open(&b->charset, name, b->path);
    return b->has_charset;
}

static bool read_glyph(struct bdf *b)
{
    struct glyph g = b->all;
    uint8_t rows[FONT_SIZE_MAX * ((FONT_SIZE_MAX + 7) / 8)] = {0};
    if ((!b->has_charset && !find_charset(b)) || !read_head(b, &g))
        return false;
    const size_t stride = ((size_t)g.box[0] + 7) / 8;
    if (!read_rows(b, stride, g.box[1], rows))
        return false;
    b->read++;
    if (g.code >= 0)
        g.code = charset_code(&b->charset, (uint32_t)g.code);
    const struct font_char c = {
        .code = (uint32_t)g.code,
        .width = g.box[0],
        .height = g.box[1],
        .left = g.box[2],
        .top = g.box[1] + g.box[3],
        .advance = g.advance >= 0 ? g.advance : g.box[0],
    };
    return g.code < 0 || font_add(b->font, &c, rows, stride);
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
        number(b, 0, FONT_CODE_MAX, &b->chars);
    else if (is(b, "FONT"))
        b->name = b->rest;
    else if (choice_find("CONTENTVERSION|SIZE|METRICSSET|SWIDTH|SWIDTH1|"
                         "DWIDTH1|VVECTOR",
                         b->word) < 0)
        b->odd[ODD_LINE]++;
    return true;
}

static void report(const struct bdf *b)
{
    char text[400] = "";
    size_t n = 0;
    for (int i = 0; i < ODD_KINDS; i++)
        if (b->odd[i] > 0 && n < sizeof text)
            n += (size_t)snprintf(text + n, sizeof text - n, "%s%u %s",
                                  n ? ", " : "", b->odd[i], odd_names[i]);
    if (n > 0)
        message_error_at(b->path, 0, "is read in spite of: %s", text);
}

/* The lines of a font without properties are as high as its box. */
static bool finish(struct bdf *b)
{
    const int *box = b->all.box;
    const int above = box[1] + box[3], below = -box[3];
    b->odd[ODD_COUNT] += b->chars != b->read;
    if (b->ascent == 0 && above > 0) {
        b->odd[ODD_HEIGHT]++;
        b->ascent = -1;
    }
    if (b->missing >= 0 && b->has_charset)
        b->missing = (int)charset_code(&b->charset, (uint32_t)b->missing);
    b->font->missing = b->missing;
    b->font->ascent = b->ascent >= 0 ? b->ascent : above > 0 ? above : 0;
    b->font->descent = b->descent >= 0 ? b->descent : below > 0 ? below : 0;
    if (b->read > 0)
        report(b);
    return true;
}

static bool read_all(struct bdf *b)
{
    if (!next_line(b) || !is(b, "STARTFONT"))
        return ERROR_AT(b, "'%s': expected STARTFONT 2.1", b->word);
    while (next_line(b)) {
        if (is(b, "ENDFONT"))
            return finish(b);
        if (!read_entry(b))
            return false;
    }
    b->odd[ODD_END]++;
    return finish(b);
}

bool font_parse_bdf(struct font *font, const struct font_file *file)
{
    struct bdf b = {
        .font = font,
        .path = file->path,
        .next = file->data,
        .end = file->data + file->size,
        .word = file->data,
        .wanted_encoding = file->options.encoding,
        .name = "",
        .registry = "",
        .encoding = "",
        .all = {.code = -1, .advance = -1},
        .ascent = -1,
        .descent = -1,
        .missing = -1,
        .chars = -1,
    };
    const bool done = read_all(&b);
    if (!b.has_charset)
        return done;
    if (done)
        charset_report(&b.charset, file->path);
    charset_close(&b.charset);
    return done;
}
