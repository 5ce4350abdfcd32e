#include "shading.h"

static const struct pel_paint *paint(struct pel_frame *frame,
                                     const struct pel_color_paint *surface)
{
    const struct pel_mesh *mesh = frame->scene->mesh;
    struct pel_frame_triangle *t = &frame->work->triangle;
    struct pel_phong *p = &frame->work->paint.phong;
    int32_t value[3][3];
    pel_color color[3];
    pel_phong_init(p, frame->opaque);
    p->lights = &frame->lights;
    p->surface = surface;
    p->alpha = frame->alpha;
    for (int i = 0; i < 3; i++)
        pel_mesh_normal(mesh, t->vertex[i], value[i]);
    pel_frame_planes(frame, value, p->plane);
    for (int i = 0; i < 3; i++)
        pel_mesh_lights_position(&frame->lights, mesh->positions[t->vertex[i]],
                                 value[i]);
    pel_frame_planes(frame, value, p->plane + 3);
    if (!surface) {
        pel_frame_colors(frame, color);
        pel_frame_gouraud(frame, color, &p->colors);
    }
    return &p->base.paint;
}

const struct pel_shading pel_shade_phong = {pel_shade_start_light, NULL, paint};
