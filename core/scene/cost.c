#include "cost.h"

const struct pel_scene_rates pel_scene_cost_m0plus[PEL_SCENE_COSTS] = {
    {900, 700, 40000, {6350, 0, 4, 68, 83, 2, 8}},
    {900, 700, 40000, {8800, 1200, 4, 100, 165, 90, 246}},
    {900, 700, 40000, {24300, 7700, 4, 66, 83, 0, 55500}},
};

const struct pel_scene_rates pel_scene_cost_m4[PEL_SCENE_COSTS] = {
    {500, 400, 14000, {2250, 0, 2, 56, 74, 2, 7}},
    {500, 400, 14000, {1880, 800, 6, 90, 132, 45, 157}},
    {500, 400, 14000, {3900, 800, 4, 54, 74, 0, 18900}},
};

/* Clipping leaves PEL_CLIP_CORNERS corners at most, a fan of two less. */
enum { FAN = PEL_CLIP_CORNERS - 2, TURNS = 3 * (24 + 16) };

static void add_cut(struct pel_cost *cost, const struct pel_rect *clip,
                    const struct pel_scene_rates *rates)
{
    const struct pel_cost_rates *r = &rates->drawn;
    const uint32_t rows = (uint32_t)(clip->y1 - clip->y0);
    const uint32_t pixels = rows * (uint32_t)(clip->x1 - clip->x0);
    cost->triangles += FAN;
    cost->rows += FAN * rows;
    cost->pixels += pixels;
    cost->instructions += rates->cut +
                          FAN * (r->triangle + r->thin + TURNS * r->turn) +
                          (uint64_t)FAN * rows * (r->cut_row + r->run) +
                          ((pel_multiply(pixels, r->pixel) + 15) >> 4);
}

/* False when a vertex is not on screen. */
static bool corners_of(const struct pel_frame *frame, uint32_t triangle,
                       struct pel_point at[3])
{
    uint32_t vertex[3];
    bool whole = true;
    pel_mesh_corners(frame->scene->mesh, triangle, vertex);
    for (int i = 0; i < 3; i++) {
        const struct pel_projected *v = &frame->vertex[vertex[i]].at;
        at[i] = (struct pel_point){v->x, v->y};
        whole &= v->x != PEL_NOT_ON_SCREEN;
    }
    return whole;
}

void pel_scene_cost(struct pel_cost *cost, const struct pel_frame *frame,
                    const struct pel_surface *surface,
                    const struct pel_scene_rates *rates)
{
    const struct pel_rect clip =
        pel_rect_intersect(&surface->clip, &frame->scene->viewport);
    cost->instructions += rates->frame;
    if (pel_rect_empty(&clip))
        return;
    for (uint32_t i = 0; i < frame->triangles; i++) {
        struct pel_point at[3];
        if (!corners_of(frame, frame->order ? frame->order[i].index : i, at))
            add_cut(cost, &clip, rates);
        else if (pel_box_meets(at, &clip))
            pel_triangle_cost(cost, at, &clip, &rates->drawn);
        else
            cost->instructions += rates->beside;
    }
}
