#include "glyph.h"

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
