#include "select.h"

/* False: some vertex is cut off. */
static bool range_of(const struct pel_frame *frame, int32_t *first,
                     int32_t *last)
{
    *first = INT32_MAX;
    *last = 0;
    for (uint32_t i = 0; i < frame->scene->mesh->vertices; i++) {
        const struct pel_projected *v = &frame->vertex[i].at;
        if (v->x == PEL_NOT_ON_SCREEN)
            return false;
        *first = pel_min(*first, v->z);
        *last = pel_max(*last, v->z);
    }
    return true;
}

/* Coarse numbers are cut by less than 1. */
int pel_scene_depth_bits(const struct pel_frame *frame, pel_length gap)
{
    const struct pel_projector *p = &frame->projector;
    const int64_t near = p->near_coarse - 1;
    int32_t first, last;
    if (gap <= 0 || !range_of(frame, &first, &last))
        return 32;
    int64_t coarse = pel_scale_down(gap, 16 - p->fine_bits + p->coarse) - 1;
    if (p->one)
        return coarse - 1 >= (1 << 15) + 4 ? 16 : 32;
    const int64_t far = last + 1, ratio = far / first + 1;
    const int64_t limit = INT64_C(1) << 29;
    coarse = (coarse < limit ? coarse : limit) - ratio * ratio;
    return near * coarse >= (far * far >> 15) + (far * far >> 27) + 2 ? 16 : 32;
}
