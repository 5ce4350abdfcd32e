#include "blend32.h"

#if PEL_VECTORS

enum { ROWS_AHEAD = 4 };

void pel_blend32_rows(const struct pel_spans *spans, pel_color color)
{
    if (pel_alpha(color) == 0)
        return; /* the X byte stays as it is, too */
    const struct pel_blend32 b =
        pel_blend32_make(spans->surface->format, color);
    const struct pel_span *span = spans->span;
    const uintptr_t ahead = ROWS_AHEAD * (uintptr_t)pel_spans_pitch(spans);
    int32_t y = spans->y;
    for (int32_t i = 0; i < spans->n; i++, span++, y += spans->step)
        pel_blend32_run(pel_address32(spans->surface, span->x0, y),
                        span->x1 - span->x0, &b, ahead);
}

#endif
