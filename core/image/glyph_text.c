#include "glyph_text.h"

#include "../base/inline.h"

/* A glyph is drawn in parts of ROWS x COLUMNS pixels. bits_at() reads whole
 * bytes: with the up to 7 columns that come with them, 24 fit 32 bits. */
enum {
    ROWS = PEL_64BIT && PEL_BATCH_ROWS > 16 ? 16
           : PEL_SMALL_CODE                 ? PEL_BATCH_ROWS / 2
                                            : PEL_BATCH_ROWS,
    COLUMNS = 24
};

/* Each row's runs of set bits are taken from right to left. */
struct part {
    int32_t x; /* of the glyph */
    struct pel_spans rows;
    struct pel_span span[ROWS]; /* the run of each row that is drawn next */
    uint32_t bits[ROWS]; /* what lies left of it, its last column lowest */
};

/* Zero bits below the lowest one, 31 at most. */
static inline int32_t zeros(uint32_t v)
{
    if (PEL_64BIT)
        v |= 0x80000000u;
    else if (v == 0)
        return 31; /* the loop need not run */
    return pel_trailing_zeros(v);
}

/* The bits of columns [x0, x1), up to COLUMNS of them. */
static uint32_t bits_at(const uint8_t *row, int32_t x0, int32_t x1)
{
    uint32_t bits = 0;
    for (int32_t i = x0 >> 3; 8 * i < x1; i++)
        bits = bits << 8 | row[i];
    return bits >> (-x1 & 7) & ((1u << (x1 - x0)) - 1);
}

/* Sets the span of each row to the next run of set bits on its left, or empty
 * at pixel `left`, and returns whether there are more. (Compilers for any
 * x86-64 count zeros from the low bit in one fast instruction.) */
static PEL_HOT bool next_runs(struct part *p, int32_t left)
{
    uint32_t more = 0;
    for (int32_t i = 0; i < p->rows.n; i++) {
        struct pel_span *span = &p->span[i];
        int32_t n = zeros(p->bits[i]);
        const uint32_t bits = p->bits[i] >> n;
        span->x1 = pel_max(span->x0 - n, left);
        n = zeros(~bits);
        span->x0 = span->x1 - n;
        p->bits[i] = bits >> n;
        more |= p->bits[i];
    }
    return more != 0;
}

/* Takes the columns of rows from `row` on; false when no bit is set. */
static PEL_HOT bool take(struct part *p, const uint8_t *row, int32_t stride,
                         const struct pel_span *columns)
{
    uint32_t all = 0;
    for (int32_t i = 0; i < p->rows.n; i++, row += stride) {
        p->span[i].x0 = columns->x1;
        p->bits[i] = bits_at(row, columns->x0 - p->x, columns->x1 - p->x);
        all |= p->bits[i];
    }
    return all != 0;
}

static bool legal(const struct pel_stencil *g, int32_t x, int32_t y)
{
    return pel_offset_legal(x, y) && g->width >= 0 && g->width <= 32767 &&
           g->height >= 0 && g->height <= 32767;
}

void pel_glyph(const struct pel_surface *surface,
               const struct pel_stencil *glyph, int32_t x, int32_t y,
               const struct pel_paint *paint)
{
    PEL_ASSERT(legal(glyph, x, y));
    if (!legal(glyph, x, y))
        return;
    struct pel_rect r = {x, y, x + glyph->width, y + glyph->height};
    r = pel_rect_intersect(&r, &surface->clip);
    if (pel_rect_empty(&r))
        return;
    struct part p;
    p.x = x;
    p.rows = (struct pel_spans){surface, p.span, r.y0, 0, 1};
    for (; p.rows.y < r.y1; p.rows.y += p.rows.n) {
        const uint8_t *row =
            glyph->bits + (ptrdiff_t)(p.rows.y - y) * (ptrdiff_t)glyph->stride;
        struct pel_span columns = {r.x0, r.x0};
        p.rows.n = pel_min(r.y1 - p.rows.y, ROWS);
        for (; columns.x0 < r.x1; columns.x0 = columns.x1) {
            columns.x1 = pel_min(columns.x0 + COLUMNS, r.x1);
            bool more = take(&p, row, glyph->stride, &columns);
            while (more) {
                more = next_runs(&p, columns.x0);
                paint->fill(paint, &p.rows);
            }
        }
    }
}

enum { REPLACEMENT = 0xFFFD };

/* How a first byte goes on: bytes that follow, and the range of the first of
 * them, which keeps out overlong forms, surrogates and more than U+10FFFF. */
struct lead {
    uint8_t count, low, high;
};

static struct lead lead_of(uint8_t byte)
{
    struct lead lead = {0, 0x80, 0xBF};
    if (byte >= 0xC2 && byte <= 0xF4)
        lead.count = byte < 0xE0 ? 1 : byte < 0xF0 ? 2 : 3;
    if (byte == 0xE0)
        lead.low = 0xA0;
    else if (byte == 0xED)
        lead.high = 0x9F;
    else if (byte == 0xF0)
        lead.low = 0x90;
    else if (byte == 0xF4)
        lead.high = 0x8F;
    return lead;
}

uint32_t pel_utf8_next(const char **text)
{
    const uint8_t *p = (const uint8_t *)*text;
    uint32_t code = *p++;
    if (code >= 0x80) {
        struct lead lead = lead_of((uint8_t)code);
        code = lead.count ? code & 0x3Fu >> lead.count : REPLACEMENT;
        for (; lead.count; lead.count--) {
            if (*p < lead.low || *p > lead.high) {
                code = REPLACEMENT;
                break;
            }
            code = code << 6 | (*p++ & 0x3Fu);
            lead.low = 0x80;
            lead.high = 0xBF;
        }
    }
    *text = (const char *)p;
    return code;
}

const struct pel_font_glyph *pel_glyph_find(const struct pel_font_asset **font,
                                            uint32_t code)
{
    const struct pel_font_asset *const first = *font;
    for (const struct pel_font_asset *f = first; f; f = f->next) {
        const uint32_t glyph = pel_font_ranges_find(f->range, f->ranges, code);
        *font = f;
        if (glyph != PEL_FONT_NONE)
            return &f->glyph[glyph];
    }
    *font = first;
    return first->missing == PEL_FONT_NONE ? NULL
                                           : &first->glyph[first->missing];
}

/* The glyph with its pen at (x, y), which is far outside of every surface when
 * the string is long enough: then it is not drawn. */
static void draw(const struct pel_surface *surface,
                 const struct pel_font_asset *font,
                 const struct pel_font_glyph *glyph, struct pel_point pen,
                 const struct pel_paint *paint)
{
    const struct pel_rect *clip = &surface->clip;
    pen.x += glyph->left;
    pen.y -= glyph->top;
    if (pen.x >= clip->x1 || pen.y >= clip->y1 ||
        pen.x + glyph->width <= clip->x0 || pen.y + glyph->height <= clip->y0)
        return;
    if (font->kind) {
        font->kind->draw(surface, font, glyph, pen, paint);
        return;
    }
    const struct pel_stencil g = {font->bits + glyph->offset,
                                  (glyph->width + 7) / 8, glyph->width,
                                  glyph->height};
    pel_glyph(surface, &g, pen.x, pen.y, paint);
}

void pel_text_until(const struct pel_surface *surface,
                    const struct pel_text_block *text, const char *end,
                    const struct pel_paint *paint)
{
    const char *next = text->string;
    const bool legal = pel_offset_legal(text->x, text->y);
    PEL_ASSERT(legal);
    if (!legal)
        return;
    struct pel_point pen = {text->x, text->y + text->font->ascent};
    const struct pel_font_glyph *before = NULL;
    while (*next && next != end) {
        uint32_t code = pel_utf8_next(&next);
        if (code == '\n') {
            pen.x = text->x;
            pen.y += text->font->ascent + text->font->descent;
            before = NULL;
            continue;
        }
        const struct pel_font_asset *font = text->font;
        const struct pel_font_glyph *glyph = pel_glyph_find(&font, code);
        if (glyph) {
            pen.x += pel_glyph_kerning(font, before, glyph);
            draw(surface, font, glyph, pen, paint);
            pen.x += glyph->advance;
            before = glyph;
        }
    }
}
