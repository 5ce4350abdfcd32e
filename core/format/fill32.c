#include "span32.h"

void pel_fill32(const struct pel_spans *spans, uint32_t pixel)
{
    const struct pel_span *span = spans->span;
    const pel_value32 value = pel_make_value32(pixel);
    const uintptr_t pitch = (uintptr_t)pel_spans_pitch(spans);
    uintptr_t row = pel_column_zero(spans->surface, spans->y, 4);
    for (int32_t n = spans->n; n > 0; n--, span++, row += pitch) {
        uintptr_t p = row + 4 * (uintptr_t)span->x0;
        int32_t pixels = span->x1 - span->x0;
        pel_prefetch_span(p + pitch, 4 * pixels);
        pel_span32((pel_word32 *)p, pixels, value);
    }
}
