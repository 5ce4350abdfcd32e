#include "blend565.h"

#if PEL_VECTORS

void pel_blend565_rows(const struct pel_spans *spans, pel_color color)
{
    const struct pel_blend565 b =
        pel_blend565_make(spans->surface->format, color);
    const struct pel_span *span = spans->span;
    int32_t y = spans->y;
    for (int32_t i = 0; i < spans->n; i++, span++, y += spans->step)
        pel_blend565_run(pel_address16(spans->surface, span->x0, y),
                         span->x1 - span->x0, &b);
}

#endif
