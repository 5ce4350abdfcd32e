#include "span16.h"

void pel_fill16(const struct pel_spans *spans, uint32_t pixel)
{
    const struct pel_span *span = spans->span;
    const pel_value16 value = pel_make_value16(pixel);
    const uintptr_t pitch = (uintptr_t)pel_spans_pitch(spans);
    uintptr_t row = pel_column_zero(spans->surface, spans->y, 2);
    const struct pel_span *const end = span + spans->n;
    do {
        pel_span16((pel_word16 *)(row + 2 * (uintptr_t)span->x0),
                   span->x1 - span->x0, value);
        span++;
        row += pitch;
    } while (span < end);
}
