#include "pipeline.h"

static const struct pel_color_paint *surface(struct pel_frame *frame)
{
    struct pel_perspective *p = &frame->work->surface_paint.perspective;
    const int32_t span = frame->scene->texture->span;
    struct pel_texture_corner corner[3];
    pel_mapping_corners(frame, corner);
    if (frame->projector.one)
        corner[0].z = corner[1].z = corner[2].z = 1;
    pel_perspective_init(p, &frame->texture, &frame->work->triangle.setup,
                         corner, span ? span : PEL_SPAN_EXACT);
    return &p->base;
}

const struct pel_mapping pel_map_perspective = {NULL, surface,
                                                pel_mapping_tint};
