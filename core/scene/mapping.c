#include "mapping.h"

/* The numerator times the texels of a side is below 2^46. */
int64_t pel_texture_coordinate(const struct pel_frame *frame, uint32_t vertex,
                               int k)
{
    const struct pel_mesh *mesh = frame->scene->mesh;
    const int64_t v = pel_long_product(
        pel_quantization_value(&mesh->texture, k, mesh->uv[vertex][k]),
        k ? frame->texture.height : frame->texture.width);
    return pel_scale_down(v, mesh->texture.shift - 16);
}

/* Differences are below 2^38; what does not fit 32 bits is mixed without its
 * last 8. */
void pel_mapping_corners(const struct pel_frame *frame,
                         struct pel_texture_corner corner[3])
{
    const struct pel_frame_triangle *t = &frame->work->triangle;
    for (int k = 0; k < 2; k++) {
        const int64_t first = pel_texture_coordinate(frame, t->vertex[0], k);
        int64_t way[3];
        int cut = 0;
        int32_t value[3], at[3];
        for (int i = 0; i < 3; i++) {
            way[i] = pel_texture_coordinate(frame, t->vertex[i], k) - first;
            if (way[i] != (int32_t)way[i])
                cut = 8;
        }
        for (int i = 0; i < 3; i++)
            value[i] = (int32_t)(way[i] >> cut);
        pel_corners_mix(t, value, at);
        for (int i = 0; i < 3; i++)
            corner[i].uv[k] = first + pel_scale_down(at[i], -cut);
    }
}

const struct pel_paint *pel_modulate(struct pel_frame *frame,
                                     const struct pel_color_paint *surface,
                                     const pel_color color[3])
{
    struct pel_modulated *p = &frame->work->paint.tinted;
    if ((color[0] & color[1] & color[2]) == UINT32_C(0xFFFFFFFF))
        return &surface->paint;
    pel_tinted_init(p, surface, frame->opaque);
    pel_frame_gouraud(frame, color, &p->tint);
    return &p->base.paint;
}
