#include "mapping.h"

/* u and v as planes of 1/256 texel are 2^-32 texel; what a plane may be too
 * low by is added, so that a place on a border stays in the upper texel. */
static void set(struct pel_frame_triangle *t, int32_t value[3],
                struct pel_texture_plane *out)
{
    struct pel_plane plane;
    for (int i = 0; i < 3; i++)
        value[i] = (int32_t)pel_scale_down(value[i], 8);
    pel_plane_set(&plane, pel_frame_setup(t), value);
    out->at = plane.at + 131072;
    out->dx = plane.dx;
    out->dy = plane.dy;
}

static const struct pel_color_paint *surface(struct pel_frame *frame)
{
    struct pel_texture *p = &frame->work->surface_paint.affine;
    int32_t u[3], v[3];
    pel_mapping_corners(frame, u, v);
    *p = frame->texture;
    set(&frame->work->triangle, u, &p->map.u);
    set(&frame->work->triangle, v, &p->map.v);
    return &p->base;
}

const struct pel_mapping pel_map_affine = {NULL, surface, pel_mapping_tint};
