#include "paint.h"

void pel_flat_fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    const struct pel_format *format = spans->surface->format;
    pel_color color = ((const struct pel_flat *)paint)->color;
    uint32_t alpha = pel_alpha(color);
    PEL_ASSERT(alpha == 255 || format->blend); /* not a fill-only twin */
    if (alpha == 255)
        format->fill(spans, format->pack(color));
    else if (format->blend)
        format->blend(spans, color);
}
