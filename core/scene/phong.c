#include "work.h"

struct pel_shaded *pel_phong_start(struct pel_frame *frame,
                                   const struct pel_color_paint *surface)
{
    struct pel_shaded *p = &frame->work->paint.shaded;
    pel_color_paint_init(&p->base, pel_lit_colors, frame->opaque);
    p->lights = &frame->lights;
    p->surface = surface;
    p->alpha = frame->alpha;
    return p;
}

void pel_phong_values(struct pel_frame *frame, const pel_color color[3],
                      pel_value_function *set)
{
    const int values =
        frame->work->paint.shaded.surface ? PEL_AT_COLOR : PEL_VALUES;
    int32_t value[3][PEL_VALUES];
    for (int i = 0; i < 3; i++) {
        pel_frame_values(frame, frame->work->triangle.vertex[i], value[i]);
        for (int k = 0; k < 3; k++)
            value[i][PEL_AT_COLOR + k] = (int32_t)(color[i] >> 8 * k & 255);
    }
    for (int k = 0; k < values; k++) {
        const int32_t at[3] = {value[0][k], value[1][k], value[2][k]};
        set(frame, k, at);
    }
}

static void set_plane(struct pel_frame *frame, int k, const int32_t vertex[3])
{
    pel_frame_plane(frame, vertex, &frame->work->paint.shaded.of.plane[k]);
}

const struct pel_paint *pel_phong_paint(struct pel_frame *frame,
                                        const struct pel_color_paint *surface,
                                        const pel_color color[3])
{
    struct pel_shaded *p = pel_phong_start(frame, surface);
    pel_phong_values(frame, color, set_plane);
    return &p->base.paint;
}

const struct pel_shading pel_shade_phong = {pel_frame_start_light, NULL,
                                            pel_phong_paint, 0};
