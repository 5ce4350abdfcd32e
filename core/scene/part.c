#include "work.h"

/* True when all numbers of uv mean points within 2^22 texels: they are below
 * 2^31, and less than 2^21 texels a whole number of pictures away. */
static bool uv_legal(const struct pel_quantization *q, int32_t texels)
{
    const int32_t u = q->offset[0], v = q->offset[1];
    const uint32_t most =
        (uint32_t)((u ^ u >> 31) | (v ^ v >> 31)) + 65535 * (uint32_t)q->step;
    if (q->shift < 0)
        return false;
    const uint32_t pictures = most >> pel_min(q->shift, 31);
    return pictures < 65536 && pictures * (uint32_t)texels < UINT32_C(1) << 21;
}

static enum pel_status set_texture(struct pel_frame *frame)
{
    const struct pel_mesh_texture *t = frame->mesh_texture;
    struct pel_texture *p = &frame->work->texture;
    if (!t->mapping || !t->sampler || !frame->scene->mesh->uv)
        return PEL_ERROR_NULL;
    if ((uint32_t)t->span > PEL_SPAN_MAX || (t->span & (t->span - 1)))
        return PEL_ERROR_RANGE;
    const enum pel_status status = t->sampler(p, &t->texels, &p->map);
    p->wrap_u = (uint8_t)t->wrap_u;
    p->wrap_v = (uint8_t)t->wrap_v;
    if (status != PEL_OK)
        return status;
    if (!uv_legal(&frame->scene->mesh->texture, p->width | p->height))
        return PEL_ERROR_RANGE;
    if (!t->mapping->surface || p->base.opaque)
        return PEL_OK;
    if (t->alpha)
        t->alpha(p);
    else
        frame->solid = false;
    frame->opaque = false;
    return PEL_OK;
}

enum pel_status pel_frame_set_part(struct pel_frame *frame, uint32_t i)
{
    const struct pel_scene *s = frame->scene;
    const struct pel_mesh *m = s->mesh;
    const struct pel_mesh_part whole = {m->vertices, m->triangles,
                                        s->color | UINT32_C(0xFF000000), 1};
    const struct pel_mesh_part *p = m->parts ? &m->part[i] : &whole;
    frame->part = i;
    frame->begin = i ? p[-1].triangles : 0;
    frame->end = p->triangles;
    frame->color = p->color;
    frame->alpha = (uint8_t)pel_round_div255(pel_alpha(p->color) *
                                             (255u - s->transparency));
    frame->opaque = frame->solid = frame->alpha == 255;
    frame->mesh_texture = NULL;
    if (!p->texture || !s->texture)
        return PEL_OK;
    if (p->texture > s->textures && p->texture > 1)
        return PEL_ERROR_RANGE;
    frame->mesh_texture = &s->texture[p->texture - 1];
    return set_texture(frame);
}

void pel_frame_find_part(struct pel_frame *frame, uint32_t triangle)
{
    uint32_t low = 0, high = frame->scene->mesh->parts - 1;
    if (triangle - frame->begin < frame->end - frame->begin)
        return;
    while (low < high) {
        const uint32_t middle = (low + high) / 2;
        if (triangle < frame->scene->mesh->part[middle].triangles)
            high = middle;
        else
            low = middle + 1;
    }
    pel_frame_set_part(frame, low);
}

static pel_color opaque_surface(const struct pel_frame *frame, uint32_t vertex)
{
    const struct pel_mesh_texture *t = frame->mesh_texture;
    const struct pel_mesh *mesh = frame->scene->mesh;
    if (t)
        return t->mapping->vertex ? t->mapping->vertex(frame, vertex)
                                  : UINT32_C(0xFFFFFFFF);
    if (!mesh->colors)
        return frame->color;
    const uint8_t *c = mesh->colors[vertex];
    return PEL_RGB(c[0], c[1], c[2]);
}

pel_color pel_frame_surface(const struct pel_frame *frame, uint32_t vertex)
{
    return (opaque_surface(frame, vertex) & 0xFFFFFFu) | (uint32_t)frame->alpha
                                                             << 24;
}
