#include "frame.h"

void pel_corners_mix(const struct pel_frame_triangle *triangle,
                     const int32_t vertex[3], int32_t corner[3])
{
    for (int i = 0; i < 3; i++) {
        const int32_t *weight = triangle->corner[i]->weight;
        corner[i] = (int32_t)pel_scale_down(pel_dot(weight, vertex), 30);
    }
}

enum pel_frame_taken pel_frame_take(const struct pel_frame *frame,
                                    uint32_t triangle, int32_t *depth)
{
    struct pel_frame_triangle *t = &frame->work->triangle;
    struct pel_clip *clip = &frame->work->clip;
    bool cut = false, before = false;
    pel_mesh_corners(frame->scene->mesh, triangle, t->vertex);
    *depth = 0;
    for (int i = 0; i < 3; i++) {
        struct pel_clip_corner *c = &clip->corner[i];
        const struct pel_projected *v = &frame->vertex[t->vertex[i]].at;
        cut |= v->x == PEL_NOT_ON_SCREEN;
        before |= v->z >= frame->projector.near_coarse;
        t->at[i] = (struct pel_point){v->x, v->y};
        clip->polygon[0][i] = c;
        c->place[2] = v->z;
        *depth += v->z;
    }
    return !before ? PEL_TAKEN_BEHIND : cut ? PEL_TAKEN_CUT : PEL_TAKEN_WHOLE;
}

const struct pel_plane_setup *pel_frame_setup(struct pel_frame *frame)
{
    struct pel_frame_triangle *t = &frame->work->triangle;
    if (!t->is_set_up)
        t->is_set_up = pel_plane_start(&t->setup, t->at);
    return &t->setup;
}

void pel_frame_plane(struct pel_frame *frame, const int32_t value[3],
                     struct pel_plane *plane)
{
    int32_t corner[3];
    pel_corners_mix(&frame->work->triangle, value, corner);
    pel_plane_set(plane, pel_frame_setup(frame), corner);
}

void pel_frame_planes(struct pel_frame *frame, int32_t value[3][3],
                      struct pel_plane plane[3])
{
    for (int k = 0; k < 3; k++) {
        const int32_t vertex[3] = {value[0][k], value[1][k], value[2][k]};
        pel_frame_plane(frame, vertex, &plane[k]);
    }
}

/* The lower 32 bits of a plane are what struct pel_gouraud has. */
void pel_frame_gouraud(struct pel_frame *frame, const pel_color color[3],
                       struct pel_gouraud *paint)
{
    paint->paint =
        (struct pel_paint)PEL_PAINT(pel_gouraud_fill, pel_gouraud_fast);
    for (int k = 0; k < 4; k++) {
        struct pel_plane plane;
        int32_t value[3];
        for (int i = 0; i < 3; i++)
            value[i] = (int32_t)(color[i] >> 8 * k & 255);
        pel_frame_plane(frame, value, &plane);
        paint->at[k] = (uint32_t)plane.at + 0x800000u;
        paint->dx[k] = (uint32_t)plane.dx;
        paint->dy[k] = (uint32_t)plane.dy;
    }
}

void pel_frame_colors(const struct pel_frame *frame, pel_color color[3])
{
    for (int i = 0; i < 3; i++)
        color[i] = frame->vertex[frame->work->triangle.vertex[i]].color;
}

/* Do the xs, or the ys, reach into pixels [first, end)? */
static PEL_NOINLINE_32 bool range_meets(const struct pel_point at[3], bool y,
                                        int32_t first, int32_t end)
{
    int32_t low = INT32_MAX, high = INT32_MIN;
    for (int i = 0; i < 3; i++) {
        const int32_t v = y ? at[i].y : at[i].x;
        low = pel_min(low, v);
        high = pel_max(high, v);
    }
    return high > first * 256 && low < end * 256;
}

bool pel_frame_shows(const struct pel_frame *frame,
                     const struct pel_point at[3], const struct pel_rect *rect)
{
    return range_meets(at, false, rect->x0, rect->x1) &&
           range_meets(at, true, rect->y0, rect->y1) &&
           pel_side_drawn(frame->scene->cull, pel_triangle_area(at));
}
