#include <string.h>

#include "formats.h"

#define BITS 1
#define PAGES 1
#include "gray.inc"
#include "body_bits.inc"

/* Are all spans the same columns of one row after the other? */
static bool is_block(const struct pel_spans *spans)
{
    const struct pel_span *first = spans->span, *last = first + spans->n - 1;
    for (; last > first; last--)
        if (last->x0 != first->x0 || last->x1 != first->x1)
            return false;
    return spans->step;
}

/* A page at a time: its bytes are written once, and not read where all eight
 * rows are. */
static void fill_block(const struct pel_spans *spans, uint32_t set)
{
    const struct pel_surface *s = spans->surface;
    const int32_t x0 = spans->span->x0, end = spans->y + spans->n;
    const int32_t n = spans->span->x1 - x0;
    int32_t y = spans->y;
    place p = at(s, x0, y);
    for (int32_t next; n > 0 && y < end; y = next, p.byte += s->stride) {
        next = pel_min((y | 7) + 1, end);
        const uint32_t bits = ((1u << (next - y)) - 1) << (y & 7);
        if (bits == 0xFF)
            memset(p.byte, (int)set, (size_t)n);
        else
            for (int32_t i = 0; i < n; i++)
                p.byte[i] = (uint8_t)((p.byte[i] & ~bits) | (set & bits));
    }
}

/* A span longer than a row is all of memory (pel_clear). */
static void fill(const struct pel_spans *spans, uint32_t pixel)
{
    const struct pel_surface *s = spans->surface;
    const struct pel_span *span = spans->span;
    int32_t y = spans->y, n = span->x1 - span->x0;
    if (n > s->stride) {
        memset(s->pixels, pixel ? 0xFF : 0, (size_t)n / 8);
    } else if (is_block(spans)) {
        fill_block(spans, pixel ? 0xFF : 0);
    } else {
        for (int i = 0; i < spans->n; i++, span++, y += spans->step) {
            place p = at(s, span->x0, y);
            for (n = span->x1 - span->x0; n > 0; n--, p = next(p))
                set(p, pixel);
        }
    }
}

const struct pel_format pel_mono1_pages = {
    .id = PEL_FORMAT_MONO1_PAGES,
    .fill = fill,
    .blend = pel_blend_mono,
    FORMAT_BITS,
};
