#include "shading.h"

enum pel_status pel_shade_start_light(struct pel_frame *frame)
{
    const struct pel_scene *s = frame->scene;
    if (!s->lighting || (!s->mesh->normals8 && !s->mesh->normals16))
        return PEL_ERROR_NULL;
    return pel_mesh_lights_init(&frame->lights, s->lighting, s->mesh,
                                s->pose ? s->pose : &pel_pose_none,
                                s->camera.eye);
}

pel_color pel_shade_light_vertex(const struct pel_frame *frame, uint32_t vertex,
                                 pel_color surface)
{
    const struct pel_mesh *mesh = frame->scene->mesh;
    struct pel_light_sum sum;
    int32_t position[3], normal[3];
    pel_mesh_lights_position(&frame->lights, mesh->positions[vertex], position);
    pel_mesh_normal(mesh, vertex, normal);
    pel_mesh_lights_sum(&frame->lights, position, normal, &sum);
    return pel_lit_color(&sum, surface);
}

const struct pel_shading pel_shade_lit_flat = {
    pel_shade_start_light, pel_shade_light_vertex, pel_shade_flat_paint};
const struct pel_shading pel_shade_lit_gouraud = {
    pel_shade_start_light, pel_shade_light_vertex, pel_shade_gouraud_paint};
