#include "mapping.h"

/* u and v as planes of 1/256 texel are 2^-32 texel; what a plane may be too
 * low by is added, so that a place on a border stays in the upper texel. */
static void set(struct pel_frame *frame,
                const struct pel_texture_corner corner[3], int k,
                struct pel_texture_plane *out)
{
    struct pel_plane plane;
    int32_t value[3];
    for (int i = 0; i < 3; i++)
        value[i] = (int32_t)pel_scale_down(corner[i].uv[k], 8);
    pel_plane_set(&plane, pel_frame_setup(frame), value);
    out->at = plane.at + 131072;
    out->dx = plane.dx;
    out->dy = plane.dy;
}

static const struct pel_color_paint *surface(struct pel_frame *frame)
{
    struct pel_texture *p = &frame->texture;
    struct pel_texture_corner corner[3];
    pel_mapping_corners(frame, corner);
    set(frame, corner, 0, &p->map.u);
    set(frame, corner, 1, &p->map.v);
    return &p->base;
}

const struct pel_mapping pel_map_affine = {NULL, surface, pel_modulate};
