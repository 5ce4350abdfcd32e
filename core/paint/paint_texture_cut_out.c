#include "paint_texture.h"

static void colors(const struct pel_color_paint *paint, int32_t x, int32_t y,
                   int32_t n, pel_color *out)
{
    const struct pel_texture *p = (const void *)paint;
    p->blended(paint, x, y, n, out);
    for (; n > 0; n--, out++)
        *out = *out >> 31 ? *out | UINT32_C(0xFF000000) : 0;
}

void pel_texture_cut_out(struct pel_texture *paint)
{
    paint->blended = paint->base.colors;
    pel_color_paint_init(&paint->base, colors, paint->base.opaque);
}
