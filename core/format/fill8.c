#include <string.h>

#include "word.h"

void pel_fill8(const struct pel_spans *spans, uint32_t pixel)
{
    const struct pel_span *span = spans->span;
    int32_t y = spans->y;
    for (int i = 0; i < spans->n; i++, span++, y += spans->step)
        if (span->x0 < span->x1)
            memset(pel_address8(spans->surface, span->x0, y), (int)pixel,
                   (size_t)(span->x1 - span->x0));
}
