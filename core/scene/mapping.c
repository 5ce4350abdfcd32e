#include "mapping.h"

#include "pipeline.h"

/* The numerator times the texels of a side is below 2^46, and held where what
 * it stands for is +-2^30; differences of two fit 32 bits. */
static PEL_WIDE int32_t place_of(const struct pel_mesh_quantum *q, int axis,
                                 uint16_t number, int32_t texels)
{
    const int64_t limit = (int64_t)((uint64_t)1 << (14 + q->shift));
    int64_t v =
        pel_long_product(pel_mesh_quantum_value(q, axis, number), texels);
    v = v > limit ? limit : v < -limit ? -limit : v;
    return pel_min((int32_t)pel_scale_down(v, q->shift - 16), (1 << 30) - 1);
}

void pel_mapping_place(const struct pel_frame *frame, uint32_t vertex,
                       int32_t uv[2])
{
    const struct pel_mesh *mesh = frame->scene->mesh;
    const int32_t texels[2] = {frame->texture.width, frame->texture.height};
    for (int k = 0; k < 2; k++)
        uv[k] = place_of(&mesh->texture, k, mesh->uv[vertex][k], texels[k]);
}

void pel_mapping_corners(const struct pel_frame *frame,
                         struct pel_texture_corner corner[3])
{
    const struct pel_frame_triangle *t = &frame->work->triangle;
    int32_t own[3][2];
    for (int i = 0; i < 3; i++)
        pel_mapping_place(frame, t->vertex[i], own[i]);
    for (int k = 0; k < 2; k++) {
        const int32_t value[3] = {own[0][k], own[1][k], own[2][k]};
        int32_t at[3];
        pel_corners_mix(t, value, at);
        for (int i = 0; i < 3; i++)
            corner[i].uv[k] = at[i];
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
