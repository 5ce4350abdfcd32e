#include "mapping.h"

#include "pipeline.h"

/* The numerator times the texels of a side is below 2^46, and held where what
 * it stands for is +-2^30. */
static int32_t place_of(const struct pel_mesh_quantum *q, int axis,
                        uint16_t number, int32_t texels)
{
    const int64_t limit = (int64_t)((uint64_t)1 << (14 + q->shift));
    int64_t v = (int64_t)pel_mesh_quantum_value(q, axis, number) * texels;
    v = v > limit ? limit : v < -limit ? -limit : v;
    return (int32_t)pel_scale_down(v, q->shift - 16);
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

void pel_mapping_corners(const struct pel_frame *frame, int32_t u[3],
                         int32_t v[3])
{
    const struct pel_frame_triangle *t = &frame->work->triangle;
    int32_t own_u[3], own_v[3];
    for (int i = 0; i < 3; i++) {
        int32_t uv[2];
        pel_mapping_place(frame, t->vertex[i], uv);
        own_u[i] = uv[0];
        own_v[i] = uv[1];
    }
    for (int i = 0; i < 3; i++) {
        u[i] = pel_corner_mix(&t->corner[i], own_u);
        v[i] = pel_corner_mix(&t->corner[i], own_v);
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
    pel_frame_gouraud(frame, color, &p->tint);
    return &p->base.paint;
}
