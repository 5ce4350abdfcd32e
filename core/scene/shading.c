#include "work.h"

void pel_corners_mix(const struct pel_frame_triangle *triangle,
                     const int32_t vertex[3], int32_t corner[3])
{
    for (int i = 0; i < 3; i++)
        corner[i] = pel_weighted(triangle->corner[i]->weight, vertex);
}

const struct pel_plane_setup *pel_frame_setup(struct pel_frame *frame)
{
    struct pel_frame_triangle *t = &frame->work->triangle;
    if (!t->is_set_up)
        t->is_set_up = pel_plane_start(&frame->work->setup, t->at);
    return &frame->work->setup;
}

void pel_frame_plane(struct pel_frame *frame, const int32_t value[3],
                     struct pel_plane *plane)
{
    const struct pel_frame_triangle *t = &frame->work->triangle;
    int32_t corner[3];
    if (!t->is_whole)
        pel_corners_mix(t, value, corner);
    pel_plane_set(plane, pel_frame_setup(frame), t->is_whole ? value : corner);
}

static bool is_one_color(const pel_color c[3])
{
    return c[0] == c[1] && c[1] == c[2];
}

struct pel_shaded *pel_shaded_start(struct pel_frame *frame,
                                    const struct pel_color_paint *surface,
                                    const pel_color color[3],
                                    pel_pixel_function *pixel, int first)
{
    struct pel_shaded *p = &frame->work->paint.shaded;
    pel_color_paint_init(&p->base, pel_shaded_colors, frame->opaque);
    p->pixel = pixel;
    p->first = (uint8_t)first;
    p->end =
        !first && (surface || is_one_color(color)) ? PEL_AT_COLOR : PEL_VALUES;
    p->under = color[0] | UINT32_C(0xFF000000);
    p->lights = &frame->lights;
    p->surface = surface;
    p->alpha = frame->alpha;
    return p;
}

void pel_value_plane(struct pel_frame *frame, int k, const int32_t vertex[3])
{
    pel_frame_plane(frame, vertex, &frame->work->paint.shaded.plane[k]);
}

void pel_color_planes(struct pel_frame *frame, const pel_color color[3],
                      pel_value_function *set)
{
    for (int k = 0; k < 3; k++) {
        int32_t at[3];
        for (int i = 0; i < 3; i++)
            at[i] = (int32_t)(color[i] >> 8 * k & 255);
        set(frame, PEL_AT_COLOR + k, at);
    }
}

/* The lower 32 bits of a plane are what struct pel_gouraud has. Alpha is the
 * same at all vertices of a frame. */
void pel_frame_gouraud(struct pel_frame *frame, const pel_color color[3],
                       struct pel_gouraud *paint)
{
    paint->paint = (struct pel_paint){pel_gouraud_fill, NULL};
    paint->at[3] = (color[0] >> 24 << 24) + 0x800000u;
    paint->dx[3] = paint->dy[3] = 0;
    PEL_UNROLL
    for (int k = 0; k < 3; k++) {
        struct pel_plane plane;
        const int32_t value[3] = {(int32_t)(color[0] >> 8 * k & 255),
                                  (int32_t)(color[1] >> 8 * k & 255),
                                  (int32_t)(color[2] >> 8 * k & 255)};
        pel_frame_plane(frame, value, &plane);
        paint->at[k] = (uint32_t)plane.at + 0x800000u;
        paint->dx[k] = (uint32_t)plane.dx;
        paint->dy[k] = (uint32_t)plane.dy;
    }
}

/* The mean, rounded, of each channel: 43,691 / 2^18 is 1/6, and right where the
 * product fits. */
static pel_color mean_of(const pel_color c[3])
{
    pel_color mean = 0;
    if (is_one_color(c))
        return c[0];
    for (int k = 0; k < 32; k += 8) {
        const uint32_t sum =
            (c[0] >> k & 255) + (c[1] >> k & 255) + (c[2] >> k & 255);
        mean |= (2 * sum + 3) * 43691 >> 18 << k;
    }
    return mean;
}

const struct pel_paint *pel_frame_flat_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface,
    pel_color of_all)
{
    struct pel_flat *flat = &frame->work->paint.flat;
    const pel_color color[3] = {of_all, of_all, of_all};
    if (surface)
        return frame->mesh_texture->mapping->modulate(frame, surface, color);
    flat->paint = (struct pel_paint)PEL_PAINT(pel_flat_fill, pel_flat_fast);
    flat->color = of_all;
    return &flat->paint;
}

static const struct pel_paint *flat_paint(struct pel_frame *frame,
                                          const struct pel_color_paint *surface,
                                          const pel_color color[3])
{
    return pel_frame_flat_paint(frame, surface, mean_of(color));
}

const struct pel_paint *pel_frame_gouraud_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface,
    const pel_color color[3])
{
    struct pel_gouraud *gouraud = &frame->work->paint.gouraud;
    if (surface)
        return frame->mesh_texture->mapping->modulate(frame, surface, color);
    pel_frame_gouraud(frame, color, gouraud);
    return &gouraud->paint;
}

const struct pel_shading pel_shade_flat = {NULL, NULL, flat_paint, 0};
const struct pel_shading pel_shade_gouraud = {NULL, NULL,
                                              pel_frame_gouraud_paint, 0};

static enum pel_status start_light(struct pel_frame *frame)
{
    const struct pel_scene *s = frame->scene;
    if (!s->lighting)
        return PEL_ERROR_NULL;
    return pel_mesh_lights_init(&frame->lights, s->lighting, s->mesh,
                                s->pose ? s->pose : &pel_pose_none,
                                s->camera.eye);
}

/* The three positions are below 2^29, so that their sum fits. */
static const struct pel_paint *facet_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface,
    const pel_color color[3])
{
    const struct pel_mesh *mesh = frame->scene->mesh;
    const uint32_t *vertex = frame->work->triangle.vertex;
    int32_t value[PEL_VALUES], *position = value + PEL_AT_POSITION;
    int32_t corner[3][3];
    int64_t facet[3];
    for (int i = 0; i < 3; i++)
        pel_mesh_lights_position(&frame->lights, mesh->positions[vertex[i]],
                                 corner[i]);
    PEL_UNROLL
    for (int k = 0; k < 3; k++) /* a third of the sum */
        position[k] = pel_scaled(corner[0][k] + corner[1][k] + corner[2][k],
                                 715827883, 31);
    pel_mesh_facet(mesh, vertex, facet);
    pel_normalize(facet, value + PEL_AT_NORMAL);
    pel_color_values(mean_of(color), value);
    return pel_frame_flat_paint(frame, surface,
                                pel_lit_color(&frame->lights, value) |
                                    (color[0] & UINT32_C(0xFF000000)));
}

const struct pel_shading pel_shade_lit_flat = {start_light, NULL, facet_paint,
                                               0};

enum pel_status pel_frame_start_light(struct pel_frame *frame)
{
    const struct pel_mesh *mesh = frame->scene->mesh;
    return mesh->normals8 || mesh->normals16 ? start_light(frame)
                                             : PEL_ERROR_NULL;
}

void pel_frame_values(const struct pel_frame *frame, uint32_t vertex,
                      int32_t value[PEL_LIGHT_VALUES])
{
    const struct pel_mesh *mesh = frame->scene->mesh;
    pel_mesh_normal(mesh, vertex, value + PEL_AT_NORMAL);
    pel_mesh_lights_position(&frame->lights, mesh->positions[vertex],
                             value + PEL_AT_POSITION);
}

pel_color pel_frame_light_vertex(const struct pel_frame *frame, uint32_t vertex,
                                 pel_color surface)
{
    int32_t value[PEL_VALUES];
    pel_frame_values(frame, vertex, value);
    pel_color_values(surface, value);
    return pel_lit_color(&frame->lights, value) |
           (surface & UINT32_C(0xFF000000));
}

const struct pel_shading pel_shade_lit_gouraud = {
    pel_frame_start_light, pel_frame_light_vertex, pel_frame_gouraud_paint, 0};
