#include "formats.h"

#define BITS 1
#define PAGES 1
#include "gray.inc"
#include "body_bits.inc"

static void fill(const struct pel_spans *spans, uint32_t pixel)
{
    const struct pel_span *span = spans->span;
    int32_t y = spans->y;
    for (int i = 0; i < spans->n; i++, span++, y += spans->step) {
        place p = at(spans->surface, span->x0, y);
        for (int32_t n = span->x1 - span->x0; n > 0; n--, p = next(p))
            set(p, pixel);
    }
}

const struct pel_format pel_mono1_pages = {
    .id = PEL_FORMAT_MONO1_PAGES,
    .fill = fill,
    .blend = pel_blend_mono,
    FORMAT_BITS,
};
