#include "pipeline.h"

/* Scratch memory: work, lights, vertices, order; all multiples of 8 bytes. */
typedef char pel_scene_sizes[sizeof(struct pel_mesh_light) % 8 == 0 &&
                                     sizeof(struct pel_frame_vertex) % 8 == 0
                                 ? 1
                                 : -1];

enum { WORK_SIZE = PEL_SCENE_SCRATCH_SIZE(0, 0, 0) };

/* Where the lists begin. */
struct parts {
    size_t vertices, order, end;
};

static struct parts parts_of(const struct pel_scene *scene)
{
    const struct pel_mesh *mesh = scene->mesh;
    const int32_t n = scene->lighting ? scene->lighting->lights : 0;
    const int32_t lights = pel_max(n, 0);
    return (struct parts){
        PEL_SCENE_SCRATCH_SIZE(0, 0, lights),
        PEL_SCENE_SCRATCH_SIZE(mesh->vertices, 0, lights),
        PEL_SCENE_SCRATCH_SIZE(mesh->vertices, mesh->triangles, lights)};
}

size_t pel_scene_scratch_size(const struct pel_scene *scene)
{
    return scene && scene->mesh ? parts_of(scene).end : 0;
}

/* Do all numbers of uv stand for places within 2^22 texels? They are below
 * 2^31, and less than 2^21 texels a whole number of pictures away. */
static bool reach_legal(const struct pel_quantization *q, int32_t texels)
{
    const int32_t u = q->offset[0], v = q->offset[1];
    const uint32_t most =
        (uint32_t)((u ^ u >> 31) | (v ^ v >> 31)) + 65535 * (uint32_t)q->step;
    if (q->shift < 0)
        return false;
    const uint32_t pictures = most >> pel_min(q->shift, 31);
    return pictures < 65536 && pictures * (uint32_t)texels < UINT32_C(1) << 21;
}

static enum pel_status start_texture(struct pel_frame *frame)
{
    const struct pel_mesh_texture *t = frame->scene->texture;
    static const struct pel_texture_map none = {{0, 0, 0}, {0, 0, 0}};
    if (!t)
        return PEL_OK;
    if (!t->mapping || !t->sampler || !frame->scene->mesh->uv)
        return PEL_ERROR_NULL;
    if ((uint32_t)t->span > PEL_SPAN_MAX || (t->span & (t->span - 1)))
        return PEL_ERROR_RANGE;
    const enum pel_status status =
        t->sampler(&frame->texture, &t->texels, &none);
    frame->texture.wrap_u = (uint8_t)t->wrap_u;
    frame->texture.wrap_v = (uint8_t)t->wrap_v;
    if (status != PEL_OK)
        return status;
    if (!reach_legal(&frame->scene->mesh->texture,
                     frame->texture.width | frame->texture.height))
        return PEL_ERROR_RANGE;
    if (t->mapping->surface)
        frame->opaque &= frame->texture.base.opaque;
    return PEL_OK;
}

static pel_color surface_color(const struct pel_frame *frame, uint32_t vertex)
{
    const struct pel_scene *s = frame->scene;
    if (s->texture)
        return s->texture->mapping->vertex
                   ? s->texture->mapping->vertex(frame, vertex)
                   : UINT32_C(0xFFFFFFFF);
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

static void list_triangles(struct pel_frame *frame)
{
    struct pel_depth_entry *entry = frame->order;
    const uint32_t n = frame->scene->mesh->triangles;
    for (uint32_t i = 0; i < n; i++) {
        const enum pel_frame_taken taken =
            pel_frame_take(frame, i, &entry->depth);
        entry->index = i;
        if (taken == PEL_TAKEN_CUT ||
            (taken == PEL_TAKEN_WHOLE &&
             pel_frame_shows(frame, frame->work->triangle.at,
                             &frame->scene->viewport)))
            entry++;
    }
    frame->triangles = (uint32_t)(entry - frame->order);
}

static enum pel_status start(struct pel_frame *frame)
{
    const struct pel_scene *s = frame->scene;
    enum pel_status status = pel_mesh_check(s->mesh, &frame->fault);
    if (status == PEL_OK)
        status = pel_projector_init(&frame->projector, s->mesh,
                                    s->pose ? s->pose : &pel_pose_none,
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
    const struct parts part = parts_of(scene);
    if (scratch_size < part.end || (uintptr_t)scratch % 8)
        return PEL_ERROR_SCRATCH;
    frame->scene = scene;
    frame->filter = NULL;
    frame->alpha = (uint8_t)(255 - scene->transparency);
    frame->opaque = frame->alpha == 255;
    frame->work = scratch;
    frame->lights.light = (void *)((uint8_t *)scratch + WORK_SIZE);
    frame->vertex = (void *)((uint8_t *)scratch + part.vertices);
    frame->order = (void *)((uint8_t *)scratch + part.order);
    const enum pel_status status = start(frame);
    if (status != PEL_OK)
        return status;
    place_vertices(frame);
    list_triangles(frame);
    if (scene->sort)
        scene->sort(frame->order, frame->triangles);
    return PEL_OK;
}
