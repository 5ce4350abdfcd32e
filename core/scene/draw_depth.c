#include "pipeline.h"

/* near / z, from both with all their bits: z is coarse, near fine and cut to
 * 31 bits, so the quotient has what a coarse z leaves right. */
static int32_t nearness(const struct pel_projector *p, int32_t z)
{
    if (p->one)
        return (int32_t)(PEL_DEPTH_NEAR - z);
    const int cut = pel_bits_of((uint64_t)p->near_fine) - 31;
    const int64_t near = pel_scale_down(p->near_fine, cut);
    const int64_t q =
        pel_scale_down(near * PEL_DEPTH_NEAR / z, p->coarse - cut);
    return q < PEL_DEPTH_NEAR ? (int32_t)q : PEL_DEPTH_NEAR;
}

static void set_plane(struct pel_frame *frame, struct pel_plane *plane)
{
    int32_t near[3];
    for (int i = 0; i < 3; i++)
        near[i] = nearness(&frame->projector,
                           frame->work->triangle.corner[i]->place[2]);
    pel_plane_set(plane, pel_frame_setup(frame), near);
}

static const struct pel_paint *filter(struct pel_frame *frame,
                                      const struct pel_paint *paint)
{
    struct pel_depth_paint *p = &frame->work->depth;
    struct pel_plane plane;
    set_plane(frame, &plane);
    pel_depth_paint_init(p, paint, p->depth, &plane, frame->opaque);
    return &p->base.paint;
}

/* Of a texture that is not opaque. */
static const struct pel_paint *filter_texels(struct pel_frame *frame,
                                             const struct pel_paint *paint)
{
    struct pel_depth_paint *p = &frame->work->depth;
    struct pel_plane plane;
    set_plane(frame, &plane);
    pel_depth_texels_init(p, (const void *)paint, p->depth, &plane);
    return &p->base.paint;
}

/* What is opaque is as near as what the first pass kept: the second, which only
 * tests, leaves it. */
void pel_scene_draw_depth(struct pel_frame *frame,
                          const struct pel_surface *surface,
                          const struct pel_depth *depth)
{
    frame->work->depth.depth = depth;
    if (!frame->opaque && frame->alpha == 255) {
        frame->filter = filter_texels;
        pel_scene_draw(frame, surface);
    }
    frame->filter = filter;
    pel_scene_draw(frame, surface);
    frame->filter = NULL;
}
