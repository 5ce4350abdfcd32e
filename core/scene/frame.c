#include "frame.h"

const struct pel_plane_setup *pel_frame_setup(
    struct pel_frame_triangle *triangle)
{
    if (!triangle->is_set_up)
        triangle->is_set_up = pel_plane_start(&triangle->setup, triangle->at);
    return &triangle->setup;
}

void pel_frame_planes(struct pel_frame_triangle *triangle, int n,
                      int32_t value[3][3], struct pel_plane *plane)
{
    for (int k = 0; k < n; k++) {
        const int32_t vertex[3] = {value[0][k], value[1][k], value[2][k]};
        int32_t corner[3];
        for (int i = 0; i < 3; i++)
            corner[i] = pel_corner_mix(&triangle->corner[i], vertex);
        pel_plane_set(&plane[k], pel_frame_setup(triangle), corner);
    }
}

void pel_frame_colors(const struct pel_frame *frame,
                      const struct pel_frame_triangle *triangle,
                      pel_color color[3])
{
    const struct pel_frame_vertex *v = frame->vertex;
    const uint32_t *i = triangle->vertex;
    const pel_color own[3] = {v[i[0]].color, v[i[1]].color, v[i[2]].color};
    for (int c = 0; c < 3; c++) {
        color[c] = 0;
        for (int k = 0; k < 32; k += 8) {
            const int32_t value[3] = {(int32_t)(own[0] >> k & 255),
                                      (int32_t)(own[1] >> k & 255),
                                      (int32_t)(own[2] >> k & 255)};
            color[c] |= (uint32_t)pel_corner_mix(&triangle->corner[c], value)
                        << k;
        }
    }
}

/* The lower 32 bits of a plane are what struct pel_gouraud has. */
void pel_frame_gouraud(const struct pel_frame *frame, const pel_color color[3],
                       struct pel_gouraud *paint)
{
    struct pel_plane plane;
    paint->paint =
        (struct pel_paint)PEL_PAINT(pel_gouraud_fill, pel_gouraud_fast);
    for (int k = 0; k < 4; k++) {
        int32_t value[3];
        for (int i = 0; i < 3; i++)
            value[i] = (int32_t)(color[i] >> 8 * k & 255);
        pel_plane_set(&plane, pel_frame_setup(&frame->work->triangle), value);
        paint->at[k] = (uint32_t)plane.at + 0x800000u;
        paint->dx[k] = (uint32_t)plane.dx;
        paint->dy[k] = (uint32_t)plane.dy;
    }
}

static bool range_meets(int32_t a, int32_t b, int32_t c, int32_t first,
                        int32_t end)
{
    return pel_max(pel_max(a, b), c) > first * 256 &&
           pel_min(pel_min(a, b), c) < end * 256;
}

bool pel_frame_meets(const struct pel_point *at, const struct pel_rect *rect)
{
    return range_meets(at[0].x, at[1].x, at[2].x, rect->x0, rect->x1) &&
           range_meets(at[0].y, at[1].y, at[2].y, rect->y0, rect->y1);
}
