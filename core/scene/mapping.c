#include "work.h"

/* u (k = 0) or v (1) of a vertex, 1/65,536 texel. The numerator times the
 * texels of a side is below 2^46. */
static int64_t texel_of(const struct pel_frame *frame, uint32_t vertex, int k)
{
    const struct pel_mesh *mesh = frame->scene->mesh;
    const int64_t v = pel_long_product(
        pel_quantization_value(&mesh->texture, k, mesh->uv[vertex][k]),
        k ? frame->work->texture.height : frame->work->texture.width);
    return pel_scale_down(v, mesh->texture.shift - 16);
}

/* Differences are below 2^38; where one does not fit 32 bits, all three are
 * mixed without their last 8 bits. */
void pel_frame_texels(const struct pel_frame *frame,
                      struct pel_texture_corner corner[3])
{
    const struct pel_frame_triangle *t = &frame->work->triangle;
    for (int k = 0; k < 2; k++) {
        const int64_t first = texel_of(frame, t->vertex[0], k);
        int64_t offset[3];
        int cut = 0;
        int32_t value[3], at[3];
        for (int i = 0; i < 3; i++) {
            offset[i] = texel_of(frame, t->vertex[i], k) - first;
            if (offset[i] != (int32_t)offset[i])
                cut = 8;
        }
        for (int i = 0; i < 3; i++)
            value[i] = (int32_t)(offset[i] >> cut);
        pel_corners_mix(t, value, at);
        for (int i = 0; i < 3; i++)
            corner[i].uv[k] = first + pel_scale_down(at[i], -cut);
    }
    for (int i = 0; i < 3; i++)
        corner[i].z = frame->projector.one ? 1 : t->corner[i]->z;
}

const struct pel_paint *pel_frame_modulate(
    struct pel_frame *frame, const struct pel_color_paint *surface,
    const pel_color color[3])
{
    if ((color[0] & color[1] & color[2]) == UINT32_C(0xFFFFFFFF))
        return &surface->paint;
    struct pel_shaded *p = pel_shaded_start(frame, surface, color,
                                            pel_modulated_pixel, PEL_AT_COLOR);
    pel_color_planes(frame, color, pel_value_plane);
    return &p->base.paint;
}

static pel_color vertex_color(const struct pel_frame *frame, uint32_t vertex)
{
    struct pel_texture t = frame->work->texture;
    pel_color color;
    for (int k = 0; k < 2; k++) {
        struct pel_plane *plane = k ? &t.map.v : &t.map.u;
        plane->at = (uint64_t)texel_of(frame, vertex, k) << 16;
        plane->dx = plane->dy = 0;
    }
    t.base.colors(&t.base, 0, 0, 1, &color);
    return color | UINT32_C(0xFF000000);
}

const struct pel_mapping pel_map_vertices = {vertex_color, NULL, NULL};

const struct pel_color_paint *pel_frame_affine(struct pel_frame *frame)
{
    const struct pel_frame_triangle *t = &frame->work->triangle;
    struct pel_texture *p = &frame->work->texture;
    for (int k = 0; k < 2; k++) {
        int32_t value[3], corner[3];
        for (int i = 0; i < 3; i++)
            value[i] =
                (int32_t)pel_scale_down(texel_of(frame, t->vertex[i], k), 8);
        pel_corners_mix(t, value, corner);
        pel_texture_plane(k ? &p->map.v : &p->map.u, pel_frame_setup(frame),
                          corner);
    }
    return &p->base;
}

const struct pel_mapping pel_map_affine = {NULL, pel_frame_affine,
                                           pel_frame_modulate};

static const struct pel_color_paint *perspective(struct pel_frame *frame)
{
    struct pel_divided_texture *p = &frame->work->perspective;
    struct pel_texture_corner corner[3];
    pel_frame_texels(frame, corner);
    pel_divided_texture_init(p, &frame->work->texture, pel_frame_setup(frame),
                             corner, frame->mesh_texture->span);
    return &p->by.base;
}

const struct pel_mapping pel_map_perspective = {NULL, perspective,
                                                pel_frame_modulate};
