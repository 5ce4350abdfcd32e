#include "packed.h"

/* A blend never makes the darker value the brighter one: it sets both to one
 * value or leaves both as they are. */
void pel_blend_mono(const struct pel_spans *spans, pel_color color)
{
    const struct pel_format *format = spans->surface->format;
    const uint32_t alpha = pel_alpha(color);
    const uint32_t pixel =
        format->pack(pel_mix(PEL_RGB(0, 0, 0), color, alpha));
    if (pixel == format->pack(pel_mix(PEL_RGB(255, 255, 255), color, alpha)))
        format->fill(spans, pixel);
}
