#include "gray.h"
#include "packed.h"

/* A brighter pixel stays the brighter one: where the color does not make both
 * values alike, each remains what it is. */
void pel_blend_mono(const struct pel_spans *spans, pel_color color)
{
    const struct pel_premultiplied s = pel_premultiply(color);
    const uint32_t pixel = pel_gray_over(0, &s, 1);
    if (pixel == pel_gray_over(1, &s, 1))
        spans->surface->format->fill(spans, pixel);
}
