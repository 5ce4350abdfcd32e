#include "glyph_text.h"

#include "../raster/collect.h"

/* The first of the bits i..end - 1 that differs from those of `same`, 0 or
 * 0xFF; end when none does. */
static int32_t find(const uint8_t *row, int32_t i, int32_t end, uint32_t same)
{
    for (; i < end; i = (i | 7) + 1) {
        uint32_t bits = (row[i >> 3] ^ same) << (24 + (i & 7));
        if (bits == 0)
            continue;
        for (; (int32_t)bits >= 0; bits <<= 1)
            i++;
        break;
    }
    return pel_min(i, end);
}

/* The columns [left, right) of a row whose column 0 is pixel x. */
static void collect_row(struct pel_collector *c, const uint8_t *row, int32_t x,
                        int32_t y, const struct pel_span *visible)
{
    int32_t end = visible->x1 - x;
    int32_t i = find(row, visible->x0 - x, end, 0);
    while (i < end) {
        int32_t start = i;
        i = find(row, i, end, 0xFF);
        pel_collect(c, y, x + start, x + i);
        i = find(row, i, end, 0);
    }
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
    const struct pel_span visible = {r.x0, r.x1};
    const uint8_t *row =
        glyph->bits + (ptrdiff_t)(r.y0 - y) * (ptrdiff_t)glyph->stride;
    struct pel_collector c;
    pel_collect_begin(&c, surface, paint);
    for (; r.y0 < r.y1; r.y0++, row += glyph->stride)
        collect_row(&c, row, x, r.y0, &visible);
    pel_collect_end(&c);
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

const struct pel_font_glyph *pel_glyph_find(const struct pel_font_asset *font,
                                            uint32_t code)
{
    int32_t low = 0, high = font->ranges;
    while (low < high) {
        int32_t middle = (low + high) / 2;
        const struct pel_font_range *r = &font->range[middle];
        if (code < r->first)
            high = middle;
        else if (code - r->first >= r->count)
            low = middle + 1;
        else
            return &font->glyph[r->glyph + (code - r->first)];
    }
    return font->missing == PEL_FONT_NONE ? NULL : &font->glyph[font->missing];
}

static int32_t line_height(const struct pel_font_asset *font)
{
    return font->ascent + font->descent;
}

/* The glyph with its pen at (x, y), which is far outside of every surface when
 * the string is long enough: then it is not drawn. */
static void draw(const struct pel_surface *surface,
                 const struct pel_text_block *text,
                 const struct pel_font_glyph *glyph, struct pel_point pen,
                 const struct pel_paint *paint)
{
    const struct pel_stencil g = {text->font->bits + glyph->offset,
                                  (glyph->width + 7) / 8, glyph->width,
                                  glyph->height};
    int32_t x = pen.x + glyph->left, y = pen.y - glyph->top;
    const struct pel_rect *clip = &surface->clip;
    if (x < clip->x1 && y < clip->y1 && x + g.width > clip->x0 &&
        y + g.height > clip->y0)
        pel_glyph(surface, &g, x, y, paint);
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
    while (*next && next != end) {
        uint32_t code = pel_utf8_next(&next);
        if (code == '\n') {
            pen.x = text->x;
            pen.y += line_height(text->font);
            continue;
        }
        const struct pel_font_glyph *glyph = pel_glyph_find(text->font, code);
        if (glyph) {
            draw(surface, text, glyph, pen, paint);
            pen.x += glyph->advance;
        }
    }
}

void pel_text(const struct pel_surface *surface,
              const struct pel_text_block *text, const struct pel_paint *paint)
{
    pel_text_until(surface, text, NULL, paint);
}

struct pel_text_size pel_text_measure(const struct pel_font_asset *font,
                                      const char *string)
{
    struct pel_text_size size = {0, line_height(font)};
    int32_t width = 0;
    while (*string) {
        uint32_t code = pel_utf8_next(&string);
        if (code == '\n') {
            size.height += line_height(font);
            width = 0;
            continue;
        }
        const struct pel_font_glyph *glyph = pel_glyph_find(font, code);
        width += glyph ? glyph->advance : 0;
        size.width = pel_max(size.width, width);
    }
    return size;
}
