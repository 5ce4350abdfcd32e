#include "frame.h"

void pel_frame_planes(const struct pel_frame_triangle *triangle, int n,
                      int32_t value[3][3], struct pel_plane *plane)
{
    for (int k = 0; k < n; k++) {
        const int32_t vertex[3] = {value[0][k], value[1][k], value[2][k]};
        int32_t corner[3];
        for (int i = 0; i < 3; i++)
            corner[i] = pel_corner_mix(&triangle->corner[i], vertex);
        pel_plane_set(&plane[k], &triangle->setup, corner);
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
