#include "mapping.h"

static const struct pel_color_paint *surface(struct pel_frame *frame)
{
    struct pel_texture *p = &frame->work->surface_paint.affine;
    struct pel_texture_corner corner[3];
    struct pel_texel_point t[3];
    pel_mapping_corners(frame, corner);
    for (int i = 0; i < 3; i++) {
        t[i].u = (int32_t)pel_scale_down(corner[i].u, 8);
        t[i].v = (int32_t)pel_scale_down(corner[i].v, 8);
    }
    *p = frame->texture;
    pel_texture_map_triangle(&p->map, frame->work->triangle.at, t);
    return &p->base;
}

const struct pel_mapping pel_map_affine = {NULL, surface, pel_mapping_tint};
