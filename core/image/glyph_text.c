#include "glyph_text.h"

#include "../base/inline.h"

/* A glyph is drawn in parts of ROWS x COLUMNS pixels. bits_at() reads whole
 * bytes: with the up to 7 columns that come with them, 24 fit 32 bits. */
enum {
    ROWS = PEL_64BIT && PEL_BATCH_ROWS > 16 ? 16
           : PEL_SMALL_CODE                 ? PEL_BATCH_ROWS / 2
                                            : PEL_ROWS,
    COLUMNS = 24
};

/* Each row's runs of set bits are taken from right to left. All that is kept
 * while a paint runs stands here, to spare stack. */
struct part {
    int32_t x;       /* px: of the glyph */
    uint16_t width;  /* of it, up to its last column in the clip */
    uint16_t left;   /* rows in the clip, from this part on */
    uint16_t column; /* of the glyph, where the part begins, */
    uint16_t end;    /* and where it ends */
    int32_t stride;
    const uint8_t *row; /* the bits of the first row */
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
 * where the part begins, and returns whether there are more. (Compilers for any
 * x86-64 count zeros from the low bit in one fast instruction.) */
static PEL_STEP bool next_runs(struct part *p)
{
    const int32_t left = p->x + p->column;
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

/* Takes the columns of the part; false when no bit is set. */
static PEL_STEP bool take(struct part *p)
{
    const int32_t end = pel_min(p->column + COLUMNS, p->width);
    const uint8_t *row = p->row;
    uint32_t all = 0;
    p->end = (uint16_t)end;
    for (int32_t i = 0; i < p->rows.n; i++, row += p->stride) {
        p->span[i].x0 = p->x + end;
        p->bits[i] = bits_at(row, p->column, end);
        all |= p->bits[i];
    }
    return all != 0;
}

static bool legal(const struct pel_stencil *g, int32_t x, int32_t y)
{
    return pel_offset_legal(x, y) &&
           (uint32_t)(g->width | g->height) >> 15 == 0;
}

/* False: nothing is visible. */
static PEL_STEP bool begin(struct part *p, const struct pel_stencil *glyph,
                           int32_t x, int32_t y)
{
    PEL_ASSERT(legal(glyph, x, y));
    if (!legal(glyph, x, y))
        return false;
    const struct pel_rect *const clip = &p->rows.surface->clip;
    const int32_t first = pel_max(y, clip->y0);
    const int32_t rows = pel_min(y + glyph->height, clip->y1) - first;
    const int32_t columns = pel_min(glyph->width, clip->x1 - x);
    if (rows <= 0 || columns <= pel_max(0, clip->x0 - x))
        return false;
    p->x = x;
    p->width = (uint16_t)columns;
    p->left = (uint16_t)rows;
    p->stride = glyph->stride;
    p->row = glyph->bits + (ptrdiff_t)(first - y) * (ptrdiff_t)glyph->stride;
    p->rows.y = first;
    return true;
}

void pel_glyph(const struct pel_surface *surface,
               const struct pel_stencil *glyph, int32_t x, int32_t y,
               const struct pel_paint *paint)
{
    struct part p;
    p.rows = (struct pel_spans){surface, p.span, 0, 0, 1};
    if (!begin(&p, glyph, x, y))
        return;
    for (; p.left; p.left = (uint16_t)(p.left - p.rows.n)) {
        p.rows.n = pel_min(p.left, ROWS);
        p.column = (uint16_t)pel_max(0, p.rows.surface->clip.x0 - p.x);
        for (; p.column < p.width; p.column = p.end) {
            bool more = take(&p);
            while (more) {
                more = next_runs(&p);
                paint->fill(paint, &p.rows);
            }
        }
        p.row += p.rows.n * (ptrdiff_t)p.stride;
        p.rows.y += p.rows.n;
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

/* Has the glyph at (x, y) pixels in the clip? It is far outside of every
 * surface when the string is long enough: then it is not drawn. */
static inline bool in_sight(const struct pel_surface *surface,
                            const struct pel_font_glyph *glyph, int32_t x,
                            int32_t y)
{
    const struct pel_rect *const clip = &surface->clip;
    return x < clip->x1 && y < clip->y1 && x + glyph->width > clip->x0 &&
           y + glyph->height > clip->y0;
}

/* With its pen at `pen`. What either way takes of the stack is shared. */
static PEL_ALWAYS_INLINE void draw(const struct pel_surface *surface,
                                   const struct pel_font_asset *font,
                                   const struct pel_font_glyph *glyph,
                                   struct pel_point pen,
                                   const struct pel_paint *paint)
{
    const int32_t x = pen.x + glyph->left, y = pen.y - glyph->top;
    if (!in_sight(surface, glyph, x, y))
        return;
    if (font->kind) {
        const struct pel_point at = {x, y};
        font->kind->draw(surface, font, glyph, at, paint);
    } else {
        const struct pel_stencil g = {font->bits + glyph->offset,
                                      (glyph->width + 7) / 8, glyph->width,
                                      glyph->height};
        pel_glyph(surface, &g, x, y, paint);
    }
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
