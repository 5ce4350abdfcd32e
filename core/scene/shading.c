#include "shading.h"

/* The mean, rounded, of each channel: 43,691 / 2^18 is 1/6, and right where the
 * product fits. */
static pel_color mean_of(const pel_color c[3])
{
    pel_color mean = 0;
    for (int k = 0; k < 32; k += 8) {
        const uint32_t sum =
            (c[0] >> k & 255) + (c[1] >> k & 255) + (c[2] >> k & 255);
        mean |= (2 * sum + 3) * 43691 >> 18 << k;
    }
    return mean;
}

const struct pel_paint *pel_shade_flat_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface)
{
    struct pel_flat *flat = &frame->work->paint.flat;
    pel_color color[3];
    pel_frame_colors(frame, color);
    color[0] = color[1] = color[2] = mean_of(color);
    if (surface)
        return frame->scene->texture->mapping->modulate(frame, surface, color);
    flat->paint = (struct pel_paint)PEL_PAINT(pel_flat_fill, pel_flat_fast);
    flat->color = color[0];
    return &flat->paint;
}

const struct pel_paint *pel_shade_gouraud_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface)
{
    struct pel_gouraud *gouraud = &frame->work->paint.gouraud;
    pel_color color[3];
    pel_frame_colors(frame, color);
    if (surface)
        return frame->scene->texture->mapping->modulate(frame, surface, color);
    pel_frame_gouraud(frame, color, gouraud);
    return &gouraud->paint;
}

const struct pel_shading pel_shade_flat = {NULL, NULL, pel_shade_flat_paint};
const struct pel_shading pel_shade_gouraud = {NULL, NULL,
                                              pel_shade_gouraud_paint};
