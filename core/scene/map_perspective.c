#include "mapping.h"

static const struct pel_color_paint *surface(struct pel_frame *frame)
{
    struct pel_perspective *p = &frame->work->perspective;
    const int32_t span = frame->scene->texture->span;
    struct pel_texture_corner corner[3];
    pel_mapping_corners(frame, corner);
    for (int i = 0; i < 3; i++)
        corner[i].z = frame->projector.one
                          ? 1
                          : frame->work->triangle.corner[i]->place[2];
    pel_perspective_init(p, &frame->texture, pel_frame_setup(frame), corner,
                         span);
    return &p->base;
}

const struct pel_mapping pel_map_perspective = {NULL, surface, pel_modulate};
