/* The walk over the rows of a ring: that of a disc, and the disc inside. */
#ifndef PEL_RASTER_RING_WALK_H
#define PEL_RASTER_RING_WALK_H

#include "disc_walk.h"
#include "ring.h"

struct pel_ring_walk {
    struct pel_disc_walk outer;
    struct pel_disc hole;
    int64_t less; /* outer^2 - inner^2: the hole's reach is so much less */
};

/* false: nothing is covered, or the ring is out of range (PEL_ASSERT). */
static inline bool pel_ring_start(struct pel_ring_walk *w,
                                  const struct pel_ring_shape *ring,
                                  const struct pel_rect *clip)
{
    const struct pel_point center = ring->center;
    PEL_ASSERT(pel_radius_legal(ring->inner));
    if (!pel_radius_legal(ring->inner) ||
        !pel_disc_walk_start(&w->outer, center, ring->outer, clip))
        return false;
    w->less = pel_square(ring->outer) - pel_square(ring->inner);
    pel_disc_start(&w->hole, center.x, center.x, clip);
    return true;
}

/* The runs of the row in which w->outer stands: of the whole, and of the hole,
 * which may be empty. */
static inline struct pel_row pel_ring_outer(struct pel_ring_walk *w)
{
    return pel_disc_walk_row(&w->outer);
}

static inline struct pel_row pel_ring_hole(struct pel_ring_walk *w)
{
    return pel_disc_row(&w->hole, w->outer.reach - w->less);
}

#endif
