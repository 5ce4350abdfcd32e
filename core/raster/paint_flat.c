#include "paint.h"

void pel_flat_fill(const struct pel_paint *paint, const struct pel_rows *rows)
{
    const struct pel_format *format = rows->surface->format;
    pel_color color = ((const struct pel_flat *)paint)->color;
    uint32_t alpha = pel_alpha(color);
    if (alpha == 255) {
        format->fill(rows, format->pack(color));
    } else if (alpha != 0) {
        PEL_ASSERT(format->blend); /* a fill-only twin cannot blend */
        if (format->blend)
            format->blend(rows, color);
    }
}
