#include "mapping.h"
#include "shading.h"

const struct pel_paint *pel_shade_gouraud_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface)
{
    struct pel_frame_work *work = frame->work;
    pel_color color[3];
    pel_frame_colors(frame, color);
    if (surface)
        return frame->scene->texture->mapping->tint(frame, surface, color);
    pel_frame_gouraud(frame, color, &work->paint.gouraud);
    return &work->paint.gouraud.paint;
}

const struct pel_shading pel_shade_gouraud = {NULL, NULL,
                                              pel_shade_gouraud_paint};
