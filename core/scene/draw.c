#include "pipeline.h"

/* work->triangle has its corners, and an area. */
static void draw_triangle(struct pel_frame *frame)
{
    struct pel_frame_work *work = frame->work;
    const struct pel_mesh_texture *texture = frame->scene->texture;
    const struct pel_color_paint *surface = NULL;
    work->triangle.is_set_up = false;
    if (texture && texture->mapping->surface)
        surface = texture->mapping->surface(frame);
    const struct pel_paint *paint =
        frame->scene->shading->paint(frame, surface);
    if (frame->filter)
        paint = frame->filter(frame, paint);
    pel_triangle(&work->surface, work->triangle.at, paint);
}

void pel_frame_set_corner(struct pel_frame *frame, int i,
                          const struct pel_clip_corner *corner)
{
    struct pel_frame_triangle *t = &frame->work->triangle;
    t->corner[i] = corner;
    for (int k = 0; k < 3; k++) {
        const struct pel_projected *v = &frame->vertex[t->vertex[k]].at;
        if (corner->weight[k] == PEL_COSINE_ONE && v->x != PEL_NOT_ON_SCREEN) {
            t->at[i] = (struct pel_point){v->x, v->y};
            return;
        }
    }
    t->at[i] = pel_project_clipped(&frame->projector, corner->place);
}

/* Cuts the triangle that has been taken. */
static int32_t clip(struct pel_frame *frame)
{
    const struct pel_mesh *mesh = frame->scene->mesh;
    struct pel_frame_work *work = frame->work;
    for (int i = 0; i < 3; i++)
        pel_project_coarse(&frame->projector,
                           mesh->positions[work->triangle.vertex[i]],
                           work->clip.corner[i].place);
    return pel_clip_triangle(&frame->projector, &work->clip);
}

/* What is left as a fan around its first corner. */
static void draw_entry(struct pel_frame *frame, uint32_t triangle)
{
    const struct pel_point *at = frame->work->triangle.at;
    struct pel_clip_corner *const *corner = frame->work->clip.polygon[0];
    int32_t depth, n = 3;
    if (pel_frame_take(frame, triangle, &depth) == PEL_TAKEN_CUT)
        n = clip(frame);
    for (int32_t i = 2; i < n; i++) {
        pel_frame_set_corner(frame, 0, corner[0]);
        pel_frame_set_corner(frame, 1, corner[i - 1]);
        pel_frame_set_corner(frame, 2, corner[i]);
        if (pel_frame_shows(frame, at, &frame->work->surface.clip))
            draw_triangle(frame);
    }
}

void pel_scene_draw(struct pel_frame *frame, const struct pel_surface *surface)
{
    struct pel_surface *target = &frame->work->surface;
    if (frame->triangles == 0 || frame->alpha == 0)
        return;
    pel_clip_start(&frame->work->clip);
    *target = *surface;
    target->clip = pel_rect_intersect(&surface->clip, &frame->scene->viewport);
    if (pel_rect_empty(&target->clip))
        return;
    for (uint32_t i = 0; i < frame->triangles; i++)
        draw_entry(frame, frame->order[i].index);
}
