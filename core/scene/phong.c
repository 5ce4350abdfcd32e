#include "work.h"

void pel_phong_values(struct pel_frame *frame, const pel_color color[3],
                      pel_value_function *set)
{
    int32_t value[3][PEL_LIGHT_VALUES];
    for (int i = 0; i < 3; i++)
        pel_frame_values(frame, frame->work->triangle.vertex[i], value[i]);
    for (int k = 0; k < PEL_LIGHT_VALUES; k++) {
        const int32_t at[3] = {value[0][k], value[1][k], value[2][k]};
        set(frame, k, at);
    }
    if (frame->work->paint.shaded.end == PEL_VALUES)
        pel_color_planes(frame, color, set);
}

const struct pel_paint *pel_phong_paint(struct pel_frame *frame,
                                        const struct pel_color_paint *surface,
                                        const pel_color color[3])
{
    struct pel_shaded *p =
        pel_shaded_start(frame, surface, color, pel_lit_pixel, 0);
    pel_phong_values(frame, color, pel_value_plane);
    return &p->base.paint;
}

const struct pel_shading pel_shade_phong = {pel_frame_start_light, NULL,
                                            pel_phong_paint, 0};
