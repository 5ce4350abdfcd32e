#include "pipeline.h"

/* Scratch memory: work, lights, vertices, order, each a multiple of 8 bytes. */
static size_t rounded(size_t size)
{
    return (size + 7) & ~(size_t)7;
}

static size_t lights_size(const struct pel_scene *scene)
{
    const int32_t n = scene->lighting ? scene->lighting->lights : 0;
    return rounded((size_t)pel_max(n, 0) * sizeof(struct pel_mesh_light));
}

static size_t vertices_size(const struct pel_scene *scene)
{
    return rounded((size_t)scene->mesh->vertices *
                   sizeof(struct pel_frame_vertex));
}

size_t pel_scene_scratch_size(const struct pel_scene *scene)
{
    if (!scene || !scene->mesh)
        return 0;
    return rounded(sizeof(struct pel_frame_work)) + lights_size(scene) +
           vertices_size(scene) +
           (size_t)scene->mesh->triangles * sizeof(struct pel_depth_entry);
}

static void divide_scratch(struct pel_frame *frame, void *scratch)
{
    uint8_t *at = scratch;
    frame->work = (void *)at;
    at += rounded(sizeof(struct pel_frame_work));
    frame->lights.light = (void *)at;
    at += lights_size(frame->scene);
    frame->vertex = (void *)at;
    at += vertices_size(frame->scene);
    frame->order = (void *)at;
}

static enum pel_status start_texture(struct pel_frame *frame)
{
    const struct pel_mesh_texture *t = frame->scene->texture;
    static const struct pel_texture_map none = {{0, 0, 0}, {0, 0, 0}};
    if (!t)
        return PEL_OK;
    const bool legal_span = t->span >= 0 && t->span <= PEL_SPAN_MAX &&
                            (t->span & (t->span - 1)) == 0;
    if (!t->mapping || !t->sampler || !frame->scene->mesh->uv)
        return PEL_ERROR_NULL;
    enum pel_status status = t->sampler(&frame->texture, &t->texels, &none);
    frame->texture.wrap_u = (uint8_t)t->wrap_u;
    frame->texture.wrap_v = (uint8_t)t->wrap_v;
    if (status == PEL_OK && t->mapping->surface && !frame->texture.base.opaque)
        frame->opaque = false;
    return legal_span ? status : PEL_ERROR_RANGE;
}

static pel_color surface_color(const struct pel_frame *frame, uint32_t vertex)
{
    const struct pel_scene *s = frame->scene;
    if (s->texture && s->texture->mapping->surface)
        return UINT32_C(0xFFFFFFFF);
    if (s->texture && s->texture->mapping->vertex)
        return s->texture->mapping->vertex(frame, vertex);
    if (!s->mesh->colors)
        return s->color;
    const uint8_t *c = s->mesh->colors[vertex];
    return PEL_RGB(c[0], c[1], c[2]);
}

static void place_vertices(struct pel_frame *frame)
{
    const struct pel_scene *s = frame->scene;
    for (uint32_t i = 0; i < s->mesh->vertices; i++) {
        struct pel_frame_vertex *v = &frame->vertex[i];
        pel_project(&frame->projector, s->mesh->positions[i], &v->at);
        v->color = surface_color(frame, i);
        if (s->shading->vertex)
            v->color = s->shading->vertex(frame, i, v->color);
        v->color = (v->color & 0xFFFFFFu) | (uint32_t)frame->alpha << 24;
    }
}

/* Of a triangle that has to be clipped nothing is said here but whether all of
 * it lies behind the near plane. */
static bool may_be_seen(const struct pel_frame *frame,
                        const struct pel_projected *a,
                        const struct pel_projected *b,
                        const struct pel_projected *c)
{
    if (a->x == PEL_NOT_ON_SCREEN || b->x == PEL_NOT_ON_SCREEN ||
        c->x == PEL_NOT_ON_SCREEN)
        return pel_max(pel_max(a->z, b->z), c->z) >= frame->projector.near;
    const struct pel_point p[3] = {{a->x, a->y}, {b->x, b->y}, {c->x, c->y}};
    return pel_frame_meets(p, &frame->scene->viewport) &&
           pel_side_drawn(frame->scene->cull, pel_triangle_area(p));
}

static void list_triangles(struct pel_frame *frame)
{
    const struct pel_mesh *mesh = frame->scene->mesh;
    uint32_t corner[3];
    frame->triangles = 0;
    for (uint32_t i = 0; i < mesh->triangles; i++) {
        pel_mesh_corners(mesh, i, corner);
        const struct pel_projected *a = &frame->vertex[corner[0]].at;
        const struct pel_projected *b = &frame->vertex[corner[1]].at;
        const struct pel_projected *c = &frame->vertex[corner[2]].at;
        if (may_be_seen(frame, a, b, c))
            frame->order[frame->triangles++] =
                (struct pel_depth_entry){a->z + b->z + c->z, i};
    }
}

static enum pel_status start(struct pel_frame *frame)
{
    const struct pel_scene *s = frame->scene;
    enum pel_status status = pel_mesh_check(s->mesh, &frame->fault);
    if (status == PEL_OK)
        status = pel_projector_init(&frame->projector, s->mesh, s->pose,
                                    &s->camera, &s->viewport);
    if (status == PEL_OK)
        status = start_texture(frame);
    if (status == PEL_OK && s->shading->start)
        status = s->shading->start(frame);
    return status;
}

enum pel_status pel_scene_prepare(struct pel_frame *frame,
                                  const struct pel_scene *scene, void *scratch,
                                  size_t scratch_size)
{
    if (!frame || !scene || !scene->mesh || !scene->shading || !scratch)
        return PEL_ERROR_NULL;
    frame->triangles = 0;
    if (scratch_size < pel_scene_scratch_size(scene) || (uintptr_t)scratch % 8)
        return PEL_ERROR_SCRATCH;
    frame->scene = scene;
    frame->alpha = (uint8_t)(255 - scene->transparency);
    frame->opaque = frame->alpha == 255;
    divide_scratch(frame, scratch);
    const enum pel_status status = start(frame);
    if (status != PEL_OK)
        return status;
    place_vertices(frame);
    list_triangles(frame);
    if (scene->sort)
        scene->sort(frame->order, frame->triangles);
    return PEL_OK;
}
