#include <string.h>

#include "word.h"

/* The bits of one byte that `mask` selects. */
static void put_bits(uint8_t *p, uint32_t mask, uint32_t byte)
{
    *p = (uint8_t)((*p & ~mask) | (byte & mask));
}

/* Bits [b0, b1) of a row, the high bit of a byte first. */
static void fill_span(uint8_t *row, int32_t b0, int32_t b1, uint32_t byte)
{
    uint8_t *first = row + b0 / 8, *last = row + (b1 - 1) / 8;
    uint32_t head = 0xFFu >> (b0 & 7), tail = 0xFF00u >> (((b1 - 1) & 7) + 1);
    if (first == last) {
        put_bits(first, head & tail, byte);
        return;
    }
    put_bits(first, head, byte);
    memset(first + 1, (int)byte, (size_t)(last - first - 1));
    put_bits(last, tail, byte);
}

void pel_fill_bits(const struct pel_spans *spans, uint32_t byte)
{
    const struct pel_surface *s = spans->surface;
    const struct pel_span *span = spans->span;
    const int32_t bits = s->format->bits;
    int32_t y = spans->y;
    for (int i = 0; i < spans->n; i++, span++, y += spans->step)
        if (span->x0 < span->x1)
            fill_span(pel_surface_line(s, y), (span->x0 - s->bounds.x0) * bits,
                      (span->x1 - s->bounds.x0) * bits, byte);
}

/* A blend never makes the darker value the brighter one: it sets both to one
 * value or leaves both as they are. */
void pel_blend_mono(const struct pel_spans *spans, pel_color color)
{
    const struct pel_format *format = spans->surface->format;
    const uint32_t alpha = pel_alpha(color);
    const uint32_t pixel =
        format->pack(pel_mix(PEL_RGB(0, 0, 0), color, alpha));
    if (pixel == format->pack(pel_mix(PEL_RGB(255, 255, 255), color, alpha)))
        format->fill(spans, pixel);
}
