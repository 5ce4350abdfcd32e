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

static const struct pel_paint *filter(struct pel_frame *frame,
                                      const struct pel_paint *paint)
{
    struct pel_frame_work *work = frame->work;
    struct pel_plane plane;
    int32_t near[3];
    for (int i = 0; i < 3; i++)
        near[i] =
            nearness(&frame->projector, work->triangle.corner[i]->place[2]);
    pel_plane_set(&plane, pel_frame_setup(frame), near);
    pel_depth_paint_init(&work->depth, paint, work->depth.depth, &plane,
                         frame->opaque);
    return &work->depth.paint;
}

void pel_scene_draw_depth(struct pel_frame *frame,
                          const struct pel_surface *surface,
                          const struct pel_depth *depth)
{
    frame->work->depth.depth = depth;
    frame->filter = filter;
    pel_scene_draw(frame, surface);
    frame->filter = NULL;
}
