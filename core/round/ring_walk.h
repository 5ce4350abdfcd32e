/* The rows of a ring: a disc, and the hole inside. */
#ifndef PEL_ROUND_RING_WALK_H
#define PEL_ROUND_RING_WALK_H

#include "disc_walk.h"
#include "ring.h"

struct pel_ring_walk {
    struct pel_disc_walk outer;
    struct pel_disc hole; /* at the same row */
};

/* Does the hole hold all of the clip? A disc holds what has its farthest corner.
 */
static inline bool pel_ring_around(const struct pel_point *center,
                                   int32_t inner, const struct pel_rect *clip)
{
    const int32_t x =
        pel_max(center->x - clip->x0 * 256, clip->x1 * 256 - center->x);
    const int32_t y =
        pel_max(center->y - clip->y0 * 256, clip->y1 * 256 - center->y);
    return pel_square(x) + pel_square(y) <= pel_square(inner);
}

/* false: nothing is covered, or the ring is out of range (PEL_ASSERT). */
static inline bool pel_ring_start(struct pel_ring_walk *w,
                                  const struct pel_point *center, int32_t inner,
                                  int32_t outer, const struct pel_rect *clip)
{
    PEL_ASSERT(pel_radius_legal(inner));
    if (!pel_radius_legal(inner) ||
        !pel_disc_walk_start(&w->outer, center, outer, clip) ||
        pel_ring_around(center, inner, clip))
        return false;
    pel_disc_center(&w->hole, center->x, center->x);
    pel_disc_start(&w->hole, clip, pel_square(inner) - pel_square(w->outer.v));
    return true;
}

static inline void pel_ring_next(struct pel_ring_walk *w)
{
    pel_disc_step(&w->hole, -pel_disc_walk_step(&w->outer));
    pel_disc_walk_next(&w->outer);
}

#endif
