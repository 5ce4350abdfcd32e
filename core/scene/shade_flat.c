#include "pipeline.h"

/* The mean, rounded, of each channel. */
static pel_color mean_of(pel_color a, pel_color b, pel_color c)
{
    pel_color mean = 0;
    for (int k = 0; k < 32; k += 8) {
        const uint32_t sum = (a >> k & 255) + (b >> k & 255) + (c >> k & 255);
        mean |= (2 * sum + 3) / 6 << k;
    }
    return mean;
}

const struct pel_paint *pel_shade_flat_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface)
{
    const struct pel_flat paint = PEL_FLAT(0);
    const struct pel_frame_vertex *v = frame->vertex;
    const uint32_t *i = frame->work->triangle.vertex;
    const pel_color mean = mean_of(v[i[0]].color, v[i[1]].color, v[i[2]].color);
    const pel_color color[3] = {mean, mean, mean};
    if (surface)
        return frame->scene->texture->mapping->tint(frame, surface, color);
    frame->work->paint.flat = paint;
    frame->work->paint.flat.color = mean;
    return &frame->work->paint.flat.paint;
}

const struct pel_shading pel_shade_flat = {NULL, NULL, pel_shade_flat_paint};
