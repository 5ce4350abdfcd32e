/* PC Screen Font, the Linux console's, versions 1 and 2 (kbd's psf.h). */

#include <string.h>

#include "core/image/glyph_text.h"
#include "sim/cli/bytes.h"
#include "sim/font/charset.h"
#include "sim/font/font.h"
#include "sim/cli/message.h"

struct psf {
    struct font *font;
    const char *path;
    const uint8_t *data;
    size_t size, at; /* bytes read */
    uint32_t count, glyph_size, width, height;
    size_t glyphs; /* where they begin */
    bool has_table;
    int version;
    uint32_t last;                       /* glyph that was added */
    uint8_t seen[FONT_CODE_MAX / 8 + 1]; /* a bit for each code point */
};

static bool cut_short(const struct psf *p)
{
    return message_error_at(
        p->path, 0, "ends after %zu bytes: expected a whole PSF file", p->size);
}

static bool read_head(struct psf *p)
{
    enum { MODE_512 = 1, MODE_TABLE = 2 | 4 };
    const uint8_t *d = p->data;
    if (p->size < (p->version == 1 ? 4 : 32))
        return cut_short(p);
    if (p->version == 1) {
        p->count = d[2] & MODE_512 ? 512 : 256;
        p->has_table = d[2] & MODE_TABLE;
        p->glyph_size = p->height = d[3];
        p->width = 8;
        p->glyphs = 4;
        return true;
    }
    p->glyphs = bytes_little(d + 8, 4);
    p->has_table = d[12] & 1;
    p->count = bytes_little(d + 16, 4);
    p->glyph_size = bytes_little(d + 20, 4);
    p->height = bytes_little(d + 24, 4);
    p->width = bytes_little(d + 28, 4);
    return (bytes_little(d + 4, 4) == 0 && p->glyphs >= 32) ||
           message_error_at(p->path, 0,
                            "a PSF 2 header of version %u and %zu bytes: "
                            "expected version 0 and at least 32 bytes",
                            (unsigned)bytes_little(d + 4, 4), p->glyphs);
}

static bool check_size(const struct psf *p)
{
    if (p->width < 1 || p->width > FONT_SIZE_MAX || p->height < 1 ||
        p->height > FONT_SIZE_MAX)
        return message_error_at(
            p->path, 0, "glyphs of %u x %u: expected 1 to %d wide and high",
            (unsigned)p->width, (unsigned)p->height, FONT_SIZE_MAX);
    if (p->glyph_size != (p->width + 7) / 8 * p->height || p->count < 1)
        return message_error_at(p->path, 0,
                                "%u glyphs of %u bytes: expected %u bytes",
                                (unsigned)p->count, (unsigned)p->glyph_size,
                                (unsigned)((p->width + 7) / 8 * p->height));
    if (p->glyphs > p->size || (p->size - p->glyphs) / p->glyph_size < p->count)
        return cut_short(p);
    return true;
}

/* Cells have no baseline of their own; a quarter of the height, rounded down,
 * is usual below it. */
static bool add(struct psf *p, uint32_t glyph, uint32_t code)
{
    const struct font_char c = {
        .code = code,
        .width = (int)p->width,
        .height = (int)p->height,
        .top = p->font->ascent,
        .advance = (int)p->width,
    };
    if (code > FONT_CODE_MAX)
        return message_error_at(p->path, 0,
                                "the table names U+%X: expected up to U+10FFFF",
                                (unsigned)code);
    if (p->seen[code / 8] >> code % 8 & 1)
        return true; /* the first one counts, as on the console */
    p->seen[code / 8] |= (uint8_t)(1u << code % 8);
    if (p->font->count > 0 && p->last == glyph)
        return font_add_alias(p->font, code);
    p->last = glyph;
    return font_add(p->font, &c,
                    p->data + p->glyphs + (size_t)glyph * p->glyph_size,
                    (p->width + 7) / 8);
}

enum { CODE, SEQUENCE, END, BAD };

/* The next entry in the table of a glyph: of 16 bits, or UTF-8. */
static int next_entry(struct psf *p, uint32_t *code)
{
    const char *start = (const char *)p->data + p->at, *next = start;
    const size_t unit = p->version == 1 ? 2 : 1;
    if (p->size - p->at < unit)
        return BAD;
    p->at += unit;
    if (p->version == 1) {
        *code = bytes_little((const uint8_t *)start, 2);
        return *code == 0xFFFF ? END : *code == 0xFFFE ? SEQUENCE : CODE;
    }
    if (*start == '\xFF' || *start == '\xFE')
        return *start == '\xFF' ? END : SEQUENCE;
    *code = pel_utf8_next(&next);
    p->at = (size_t)(next - (const char *)p->data);
    return *code != 0xFFFD || strncmp(start, "\xEF\xBF\xBD", 3) == 0 ? CODE
                                                                     : BAD;
}

/* Code points of each glyph; sequences of several, which follow, are left
 * out. */
static bool read_table(struct psf *p)
{
    p->at = p->glyphs + (size_t)p->count * p->glyph_size;
    for (uint32_t glyph = 0; glyph < p->count; glyph++) {
        bool in_sequence = false;
        uint32_t code = 0;
        int entry;
        while ((entry = next_entry(p, &code)) != END) {
            in_sequence = in_sequence || entry == SEQUENCE;
            if (entry == BAD)
                return message_error_at(
                    p->path, 0,
                    "the Unicode table breaks off at byte %zu, glyph %u of %u: "
                    "expected a whole one",
                    p->at, (unsigned)glyph, (unsigned)p->count);
            if (!in_sequence && !add(p, glyph, code))
                return false;
        }
    }
    return true;
}

/* Without a table the number of a glyph is a code of the page that the console
 * has: that of the first PCs, where nobody says another. */
static bool read_page(struct psf *p, const char *encoding)
{
    struct charset charset;
    bool done = charset_open(&charset, encoding ? encoding : "CP437", p->path);
    if (!done)
        return false;
    for (uint32_t glyph = 0; done && glyph < p->count; glyph++) {
        const long code = charset_code(&charset, glyph);
        done = code < 0 || add(p, glyph, (uint32_t)code);
    }
    if (!encoding)
        message_error_at(p->path, 0,
                         "has no table of characters and is read as CP437: "
                         "--encoding names another page");
    charset_report(&charset, p->path);
    charset_close(&charset);
    return done;
}

bool font_parse_psf(struct font *font, const struct font_file *file)
{
    struct psf p = {
        .font = font,
        .path = file->path,
        .data = (const uint8_t *)file->data,
        .size = file->size,
    };
    p.version = p.data[0] == 0x36 ? 1 : 2;
    if (!read_head(&p) || !check_size(&p))
        return false;
    font->descent = (int)p.height / 4;
    font->ascent = (int)p.height - font->descent;
    font->missing = 0xFFFD;
    if (p.has_table)
        return read_table(&p);
    return read_page(&p, file->options.encoding);
}
