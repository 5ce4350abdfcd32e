#include "word.h"

void pel_fill24(const struct pel_spans *spans, uint32_t pixel)
{
    const struct pel_span *span = spans->span;
    int32_t y = spans->y;
    for (int i = 0; i < spans->n; i++, span++, y += spans->step) {
        uint8_t *p = pel_address24(spans->surface, span->x0, y);
        for (int32_t n = span->x1 - span->x0; n > 0; n--, p += 3)
            pel_put24(p, pixel);
    }
}
