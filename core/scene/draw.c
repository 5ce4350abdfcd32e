#include "draw.h"

/* What draws a triangle, the same for all of a call. */
struct drawing {
    struct pel_frame *frame;
    pel_frame_filter *filter;
    const struct pel_depth *depth;
};

/* work->triangle has its corners, and an area. */
static void draw_triangle(const struct drawing *d)
{
    struct pel_frame *frame = d->frame;
    struct pel_frame_work *work = frame->work;
    const struct pel_mesh_texture *texture = frame->scene->texture;
    const struct pel_color_paint *surface = NULL;
    work->triangle.is_set_up = false;
    if (texture && texture->mapping->surface)
        surface = texture->mapping->surface(frame);
    const struct pel_paint *paint =
        frame->scene->shading->paint(frame, surface);
    if (d->filter)
        paint = d->filter(frame, paint, d->depth);
    pel_triangle(&work->surface, work->triangle.at, paint);
}

/* A vertex that is on screen stays where all triangles around it see it. */
static void set_corner(struct pel_frame *frame, int i,
                       const struct pel_clip_corner *c)
{
    struct pel_frame_triangle *t = &frame->work->triangle;
    t->at[i] = pel_project_clipped(&frame->projector, c->place);
    t->corner[i].z = c->place[2];
    for (int k = 0; k < 3; k++) {
        const struct pel_projected *v = &frame->vertex[t->vertex[k]].at;
        t->corner[i].weight[k] = c->weight[k];
        if (c->weight[k] == PEL_COSINE_ONE && v->x != PEL_NOT_ON_SCREEN)
            t->at[i] = (struct pel_point){v->x, v->y};
    }
}

/* The polygon that is left, as a fan around its first corner. */
static void draw_clipped(const struct drawing *d)
{
    struct pel_frame *frame = d->frame;
    struct pel_frame_work *work = frame->work;
    struct pel_frame_triangle *t = &work->triangle;
    for (int i = 0; i < 3; i++)
        pel_project_coarse(&frame->projector,
                           frame->scene->mesh->positions[t->vertex[i]],
                           work->clip.spare[i].place);
    const int32_t n = pel_clip_triangle(&frame->projector, &work->clip);
    for (int32_t i = 2; i < n; i++) {
        set_corner(frame, 0, &work->clip.corner[0]);
        set_corner(frame, 1, &work->clip.corner[i - 1]);
        set_corner(frame, 2, &work->clip.corner[i]);
        if (pel_side_drawn(frame->scene->cull,
                           pel_triangle_area(frame->work->triangle.at)))
            draw_triangle(d);
    }
}

static void draw_entry(const struct drawing *d, uint32_t triangle)
{
    struct pel_frame_triangle *t = &d->frame->work->triangle;
    bool clipped = false;
    pel_mesh_corners(d->frame->scene->mesh, triangle, t->vertex);
    for (int i = 0; i < 3; i++) {
        const struct pel_projected *v = &d->frame->vertex[t->vertex[i]].at;
        clipped |= v->x == PEL_NOT_ON_SCREEN;
        t->at[i] = (struct pel_point){v->x, v->y};
        t->corner[i].z = v->z;
        for (int k = 0; k < 3; k++)
            t->corner[i].weight[k] = i == k ? PEL_COSINE_ONE : 0;
    }
    if (clipped)
        draw_clipped(d);
    else if (pel_frame_meets(t->at, &d->frame->work->surface.clip))
        draw_triangle(d);
}

void pel_frame_draw(struct pel_frame *frame, const struct pel_surface *surface,
                    pel_frame_filter *filter, const struct pel_depth *depth)
{
    const struct drawing d = {frame, filter, depth};
    struct pel_surface *target = &frame->work->surface;
    if (frame->triangles == 0 || frame->alpha == 0)
        return;
    *target = *surface;
    target->clip = pel_rect_intersect(&surface->clip, &frame->scene->viewport);
    if (pel_rect_empty(&target->clip))
        return;
    for (uint32_t i = 0; i < frame->triangles; i++)
        draw_entry(&d, frame->order[i].index);
}

void pel_scene_draw(struct pel_frame *frame, const struct pel_surface *surface)
{
    pel_frame_draw(frame, surface, NULL, NULL);
}
