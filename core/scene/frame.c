#include "frame.h"

void pel_corners_mix(const struct pel_frame_triangle *triangle,
                     const int32_t vertex[3], int32_t corner[3])
{
    for (int i = 0; i < 3; i++)
        corner[i] = pel_weighted(triangle->corner[i]->weight, vertex);
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
