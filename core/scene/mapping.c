#include "mapping.h"

#include "pipeline.h"

/* The numerator times the texels of a side is below 2^46. */
static int32_t place_of(const struct pel_mesh_quantum *q, int axis,
                        uint16_t number, int32_t texels)
{
    const int64_t limit = INT64_C(1) << 30;
    int64_t v = (int64_t)pel_mesh_quantum_value(q, axis, number) * texels;
    const int up = 16 - q->shift;
    if (up > 30)
        v = v < 0 ? -limit : v > 0 ? limit : 0;
    else if (up > 0 && pel_size_of(v) > limit >> up)
        v = v < 0 ? -limit : limit;
    else
        v = pel_scale_down(v, -up);
    return (int32_t)(v < -limit ? -limit : v > limit ? limit : v);
}

void pel_mapping_place(const struct pel_frame *frame, uint32_t vertex,
                       int32_t uv[2])
{
    const struct pel_mesh *mesh = frame->scene->mesh;
    uv[0] =
        place_of(&mesh->texture, 0, mesh->uv[vertex][0], frame->texture.width);
    uv[1] =
        place_of(&mesh->texture, 1, mesh->uv[vertex][1], frame->texture.height);
}

void pel_mapping_corners(const struct pel_frame *frame,
                         struct pel_texture_corner corner[3])
{
    const struct pel_frame_triangle *t = &frame->work->triangle;
    int32_t uv[3][2];
    for (int i = 0; i < 3; i++)
        pel_mapping_place(frame, t->vertex[i], uv[i]);
    for (int i = 0; i < 3; i++) {
        const int32_t u[3] = {uv[0][0], uv[1][0], uv[2][0]};
        const int32_t v[3] = {uv[0][1], uv[1][1], uv[2][1]};
        corner[i].u = pel_corner_mix(&t->corner[i], u);
        corner[i].v = pel_corner_mix(&t->corner[i], v);
        corner[i].z = t->corner[i].z;
    }
}

const struct pel_paint *pel_mapping_tint(struct pel_frame *frame,
                                         const struct pel_color_paint *surface,
                                         const pel_color color[3])
{
    struct pel_tinted *p = &frame->work->paint.tinted;
    if ((color[0] & color[1] & color[2]) == UINT32_C(0xFFFFFFFF))
        return &surface->paint;
    pel_tinted_init(p, surface, frame->opaque);
    pel_gouraud_init(&p->tint, frame->work->triangle.at, color);
    return &p->base.paint;
}
