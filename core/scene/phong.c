#include "shading.h"

static void set_linear(struct pel_frame *frame, int k, const int32_t vertex[3])
{
    pel_frame_plane(frame, vertex, &frame->work->paint.shaded.plane[k]);
}

static void get_values(const struct pel_frame *frame, uint32_t vertex,
                       int32_t value[PEL_AT_COLOR])
{
    const struct pel_mesh *mesh = frame->scene->mesh;
    pel_mesh_normal(mesh, vertex, value + PEL_AT_NORMAL);
    pel_mesh_lights_position(&frame->lights, mesh->positions[vertex],
                             value + PEL_AT_POSITION);
}

const struct pel_paint *pel_phong_paint(struct pel_frame *frame,
                                        const struct pel_color_paint *surface,
                                        const pel_color color[3],
                                        const struct pel_division *division)
{
    struct pel_shaded *p = &frame->work->paint.shaded;
    pel_value_function *set = set_linear;
    int32_t value[3][PEL_AT_COLOR];
    pel_color_paint_init(&p->base, pel_lit_colors, frame->opaque);
    p->lights = &frame->lights;
    p->surface = surface;
    p->alpha = frame->alpha;
    if (division && division->light(frame, color))
        set = division->value;
    else if (!surface)
        pel_frame_gouraud(frame, color, &p->colors);
    for (int i = 0; i < 3; i++)
        get_values(frame, frame->work->triangle.vertex[i], value[i]);
    for (int k = 0; k < PEL_AT_COLOR; k++) {
        const int32_t at[3] = {value[0][k], value[1][k], value[2][k]};
        set(frame, k, at);
    }
    return set == set_linear ? &p->base.paint
                             : &frame->work->divided.base.paint;
}

static const struct pel_paint *phong_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface)
{
    pel_color color[3];
    pel_frame_colors(frame, color);
    return pel_phong_paint(frame, surface, color, NULL);
}

const struct pel_shading pel_shade_phong = {pel_frame_start_light, NULL,
                                            phong_paint};
