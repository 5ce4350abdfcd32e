#include "pipeline.h"

#include "work.h"

/* Scratch memory: work, that of the shading, lights, vertices, order; all
 * multiples of 8 bytes. */
PEL_STATIC_ASSERT(pel_scene_sizes, sizeof(struct pel_mesh_light) % 8 == 0 &&
                                       sizeof(struct pel_frame_vertex) == 16 &&
                                       sizeof(struct pel_frame_work) <=
                                           PEL_SCENE_SCRATCH_SIZE(0, 0, 0));

enum { WORK_SIZE = PEL_SCENE_SCRATCH_SIZE(0, 0, 0) };

/* Offsets of the lists, bytes. */
struct parts {
    size_t lights, vertices, order, spare, end;
};

static struct parts parts_of(const struct pel_scene *scene)
{
    const struct pel_mesh *mesh = scene->mesh;
    const int32_t n = scene->lighting ? scene->lighting->lights : 0;
    const size_t lights =
        WORK_SIZE + (scene->shading ? scene->shading->memory : 0);
    const size_t vertices =
        lights + (size_t)pel_max(n, 0) * sizeof(struct pel_mesh_light);
    const size_t order =
        vertices + mesh->vertices * sizeof(struct pel_frame_vertex);
    const size_t list = mesh->triangles * sizeof(struct pel_depth_entry);
    const bool twice = scene->sort && scene->sort->needs_spare;
    return (struct parts){lights, vertices, order, order + list,
                          order + (twice ? 2 * list : list)};
}

size_t pel_scene_scratch_size(const struct pel_scene *scene)
{
    return scene && scene->mesh ? parts_of(scene).end : 0;
}

static void project_vertices(struct pel_frame *frame)
{
    const struct pel_mesh *mesh = frame->scene->mesh;
    for (uint32_t i = 0; i < mesh->vertices; i++) {
        pel_project(&frame->projector, mesh->positions[i],
                    &frame->vertex[i].at);
        frame->vertex[i].color = 0;
    }
}

static enum pel_status check_parts(struct pel_frame *frame)
{
    const uint32_t parts = frame->scene->mesh->parts;
    uint32_t part = 0;
    do {
        const enum pel_status status = pel_frame_set_part(frame, part);
        frame->fault.part = part;
        if (status != PEL_OK)
            return status;
        frame->translucent |= !frame->solid;
    } while (++part < parts);
    return PEL_OK;
}

pel_color pel_frame_color(const struct pel_frame *frame, uint32_t vertex)
{
    const struct pel_shading *shading = frame->scene->shading;
    pel_color color = frame->vertex[vertex].color;
    if (color)
        return color;
    color = pel_frame_surface(frame, vertex);
    if (shading->vertex)
        color = shading->vertex(frame, vertex, color);
    return frame->vertex[vertex].color = color;
}

enum taken { BEHIND, WHOLE, CUT };

/* Sets the work's triangle to one of the mesh: it is right when WHOLE is
 * returned; clip->corner and polygon 0 get its corners with z alone, and
 * `depth` the sum of the three z. */
static enum taken take(const struct pel_frame *frame, uint32_t triangle,
                       int32_t *depth)
{
    struct pel_frame_triangle *t = &frame->work->triangle;
    struct pel_clip *clip = &frame->work->clip;
    bool cut = false, before = false;
    pel_mesh_corners(frame->scene->mesh, triangle, t->vertex);
    *depth = 0;
    PEL_UNROLL
    for (int i = 0; i < 3; i++) {
        struct pel_clip_corner *c = &clip->corner[i];
        const struct pel_projected *v = &frame->vertex[t->vertex[i]].at;
        cut |= v->x == PEL_NOT_ON_SCREEN;
        before |= v->z >= frame->projector.near_coarse;
        t->at[i] = (struct pel_point){v->x, v->y};
        clip->polygon[0][i] = c;
        t->corner[i] = c;
        c->z = v->z;
        *depth += v->z;
    }
    t->is_whole = !cut;
    return !before ? BEHIND : cut ? CUT : WHOLE;
}

/* Do three numbers, sub-pixels, have the centre of a pixel from `begin` to
 * `end` between them? */
static PEL_HOT bool meets(int32_t a, int32_t b, int32_t c, int32_t begin,
                          int32_t end)
{
    const int32_t low = pel_min(pel_min(a, b), c);
    const int32_t high = pel_max(pel_max(a, b), c);
    return pel_max(pel_first_pixel(low), begin) <
           pel_min(pel_first_pixel(high), end);
}

/* True when the triangle's box has pixels of the rectangle and the side that is
 * seen is to be drawn. */
static bool is_shown(const struct pel_frame *frame,
                     const struct pel_point at[3], const struct pel_rect *rect)
{
    return pel_side_drawn(frame->scene->cull, pel_corners_area(at)) &&
           meets(at[0].x, at[1].x, at[2].x, rect->x0, rect->x1) &&
           meets(at[0].y, at[1].y, at[2].y, rect->y0, rect->y1);
}

static void list_triangles(struct pel_frame *frame)
{
    struct pel_depth_entry *entry = frame->order;
    const uint32_t n = frame->scene->mesh->triangles;
    for (uint32_t i = 0; i < n; i++) {
        const enum taken taken = take(frame, i, &entry->depth);
        entry->index = i;
        if (taken == BEHIND ||
            (taken == WHOLE && !is_shown(frame, frame->work->triangle.at,
                                         &frame->scene->viewport)))
            continue;
        pel_frame_find_part(frame, i);
        for (int k = 0; k < 3; k++)
            pel_frame_color(frame, frame->work->triangle.vertex[k]);
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
    if (status == PEL_OK && s->shading->start)
        status = s->shading->start(frame);
    return status == PEL_OK ? check_parts(frame) : status;
}

enum pel_status pel_scene_prepare(struct pel_frame *frame,
                                  const struct pel_scene *scene, void *scratch,
                                  size_t scratch_size)
{
    if (frame)
        frame->triangles = 0;
    if (!frame || !scene || !scene->mesh || !scene->shading || !scratch)
        return PEL_ERROR_NULL;
    const struct parts part = parts_of(scene);
    if (scratch_size < part.end || (uintptr_t)scratch % 8)
        return PEL_ERROR_SCRATCH;
    frame->scene = scene;
    frame->filter = NULL;
    frame->pass = PEL_PASS_ALL;
    frame->translucent = false;
    frame->tolerance = scene->tolerance;
    frame->lights.lighting = NULL;
    frame->work = scratch;
    frame->lights.light = (void *)((uint8_t *)scratch + part.lights);
    frame->vertex = (void *)((uint8_t *)scratch + part.vertices);
    frame->order = (void *)((uint8_t *)scratch + part.order);
    const enum pel_status status = start(frame);
    if (status != PEL_OK)
        return status;
    project_vertices(frame);
    list_triangles(frame);
    if (scene->sort)
        scene->sort->sort(frame->order, frame->triangles,
                          (void *)((uint8_t *)scratch + part.spare));
    return PEL_OK;
}

/* Draws work->triangle, which has an area. */
static void draw_triangle(struct pel_frame *frame)
{
    struct pel_frame_work *work = frame->work;
    const struct pel_mesh_texture *texture = frame->mesh_texture;
    const struct pel_color_paint *surface = NULL;
    struct pel_frame_triangle *t = &work->triangle;
    t->is_set_up = false;
    if (texture && texture->mapping->surface)
        surface = texture->mapping->surface(frame);
    for (int i = 0; i < 3; i++)
        t->color[i] = frame->vertex[t->vertex[i]].color;
    const struct pel_paint *paint =
        frame->scene->shading->paint(frame, surface, t->color);
    if (frame->filter)
        paint = frame->filter(frame, paint);
    pel_triangle(&work->surface, t->at, paint);
}

struct pel_point pel_frame_corner_at(const struct pel_frame *frame,
                                     const struct pel_clip_corner *corner)
{
    const uint32_t *vertex = frame->work->triangle.vertex;
    for (int k = 0; k < 3; k++) {
        const struct pel_projected *v = &frame->vertex[vertex[k]].at;
        if (corner->weight[k] == PEL_COSINE_ONE && v->x != PEL_NOT_ON_SCREEN)
            return (struct pel_point){v->x, v->y};
    }
    return pel_project_clipped(&frame->projector, corner->at);
}

/* Cuts the triangle that `take` has set. The places of what is left become
 * sub-pixels. */
static int32_t clip(struct pel_frame *frame)
{
    const struct pel_mesh *mesh = frame->scene->mesh;
    const uint32_t *vertex = frame->work->triangle.vertex;
    struct pel_clip *clip = &frame->work->clip;
    for (int i = 0; i < 3; i++)
        pel_project_fine(&frame->projector, mesh->positions[vertex[i]],
                         clip->corner[i].at);
    const int32_t n = pel_clip_triangle(&frame->projector, clip);
    for (int32_t i = 0; i < n; i++) {
        struct pel_clip_corner *corner = clip->polygon[0][i];
        const struct pel_point at = pel_frame_corner_at(frame, corner);
        corner->at[0] = at.x;
        corner->at[1] = at.y;
    }
    return n;
}

/* Sets the work's triangle to corners 0, i - 1 and i of what is left of one;
 * twice its area. */
static int64_t set_fan(struct pel_frame *frame, int32_t i)
{
    struct pel_clip_corner *const *corner = frame->work->clip.polygon[0];
    struct pel_frame_triangle *t = &frame->work->triangle;
    for (int k = 0; k < 3; k++) {
        const struct pel_clip_corner *c = corner[k ? i - 2 + k : 0];
        t->corner[k] = c;
        t->at[k] = (struct pel_point){(int32_t)c->at[0], (int32_t)c->at[1]};
    }
    return pel_corners_area(t->at);
}

/* Draws what is left of a triangle as a fan around its first corner. Rounding
 * to sub-pixels may bend a sliver: where the fan turns back, the corner before
 * is left out if nothing has been drawn yet, else the corner behind, so that
 * no pixel is hit twice. */
static void draw_cut(struct pel_frame *frame)
{
    struct pel_clip_corner **corner = frame->work->clip.polygon[0];
    const int32_t n = clip(frame);
    int64_t whole = 0;
    bool begun = false;
    for (int32_t i = 2; i < n; i++)
        whole += set_fan(frame, i);
    for (int32_t i = 2; i < n; i++) {
        const int64_t area = set_fan(frame, i);
        const bool back = whole < 0 ? area > 0 : area < 0;
        if (back && begun)
            corner[i] = corner[i - 1];
        begun |= !back;
        if (!back && is_shown(frame, frame->work->triangle.at,
                              &frame->work->surface.clip))
            draw_triangle(frame);
    }
}

/* Is a triangle of this part drawn in this pass? */
static bool part_drawn(const struct pel_frame *frame)
{
    return frame->alpha != 0 &&
           !(frame->pass == PEL_PASS_FIRST && frame->alpha < 255) &&
           !(frame->pass == PEL_PASS_TRANSLUCENT && frame->solid);
}

static void draw_entry(struct pel_frame *frame, uint32_t triangle, bool all)
{
    int32_t depth;
    pel_frame_find_part(frame, triangle);
    if (!part_drawn(frame))
        return;
    const enum taken taken = take(frame, triangle, &depth);
    if (taken == CUT)
        draw_cut(frame);
    else if (taken == WHOLE && (all || is_shown(frame, frame->work->triangle.at,
                                                &frame->work->surface.clip)))
        draw_triangle(frame);
}

void pel_scene_draw(struct pel_frame *frame, const struct pel_surface *surface)
{
    if (frame->triangles == 0)
        return;
    struct pel_surface *target = &frame->work->surface;
    pel_clip_start(&frame->work->clip);
    *target = *surface;
    target->clip = pel_rect_intersect(&surface->clip, &frame->scene->viewport);
    if (pel_rect_empty(&target->clip))
        return;
    /* A list of few bytes tests them again. */
    const bool all = !PEL_SMALL_CODE && frame->order &&
                     pel_rect_inside(&frame->scene->viewport, &surface->clip);
    for (uint32_t i = 0; i < frame->triangles; i++)
        draw_entry(frame, frame->order ? frame->order[i].index : i, all);
}
