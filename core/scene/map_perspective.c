#include "pipeline.h"

static const struct pel_color_paint *surface(struct pel_frame *frame)
{
    struct pel_perspective *p = &frame->work->surface_paint.perspective;
    const int32_t span = frame->scene->texture->span;
    struct pel_texture_corner corner[3];
    int32_t u[3], v[3];
    pel_mapping_corners(frame, u, v);
    for (int i = 0; i < 3; i++) {
        const int32_t z = frame->work->triangle.corner[i].z;
        corner[i] = (struct pel_texture_corner){u[i], v[i],
                                                frame->projector.one ? 1 : z};
    }
    pel_perspective_init(p, &frame->texture,
                         pel_frame_setup(&frame->work->triangle), corner,
                         span ? span : PEL_SPAN_EXACT);
    return &p->base;
}

const struct pel_mapping pel_map_perspective = {NULL, surface,
                                                pel_mapping_tint};
