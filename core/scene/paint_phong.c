#include "paint_phong.h"

#include "shading.h"

/* Not inlined: its stack is free while the surface computes its colors. */
static PEL_NOINLINE void light(const struct pel_phong *p, int32_t x, int32_t y,
                               int32_t n, pel_color *out)
{
    struct pel_phong_row row;
    pel_phong_start(&row, p, x, x, y);
    for (; n > 0; n--, out++) {
        struct pel_light_sum sum;
        pel_phong_light(&row, p, 0, &sum);
        *out = pel_phong_color(&row, p, &sum, *out);
    }
}

void pel_phong_colors(const struct pel_color_paint *paint, int32_t x, int32_t y,
                      int32_t n, pel_color *out)
{
    const struct pel_phong *p = (const void *)paint;
    pel_phong_surface(p, x, y, n, out);
    light(p, x, y, n, out);
}

/* The planes of three values, value[i][k] at vertex i. */
static void set_planes(struct pel_frame *frame, int32_t value[3][3],
                       struct pel_plane plane[3])
{
    for (int k = 0; k < 3; k++) {
        const int32_t vertex[3] = {value[0][k], value[1][k], value[2][k]};
        pel_frame_plane(frame, vertex, &plane[k]);
    }
}

struct pel_phong *pel_phong_paint(struct pel_frame *frame,
                                  const struct pel_color_paint *surface,
                                  const pel_color color[3])
{
    const struct pel_mesh *mesh = frame->scene->mesh;
    const uint32_t *vertex = frame->work->triangle.vertex;
    struct pel_phong *p = &frame->work->paint.phong;
    int32_t value[3][3];
    pel_color_paint_init(&p->base, pel_phong_colors, frame->opaque);
    p->lights = &frame->lights;
    p->surface = surface;
    p->alpha = frame->alpha;
    for (int i = 0; i < 3; i++)
        pel_mesh_normal(mesh, vertex[i], value[i]);
    set_planes(frame, value, p->plane);
    for (int i = 0; i < 3; i++)
        pel_mesh_lights_position(&frame->lights, mesh->positions[vertex[i]],
                                 value[i]);
    set_planes(frame, value, p->plane + 3);
    if (!surface)
        pel_frame_gouraud(frame, color, &p->colors);
    return p;
}

static const struct pel_paint *phong_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface)
{
    pel_color color[3];
    pel_frame_colors(frame, color);
    return &pel_phong_paint(frame, surface, color)->base.paint;
}

const struct pel_shading pel_shade_phong = {pel_frame_start_light, NULL,
                                            phong_paint};
