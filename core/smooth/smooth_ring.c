#include "smooth_ring.h"

#include "round.h"

/* False: nothing is to be seen. */
static PEL_NOINLINE_32 bool begin(struct pel_smooth_round *t,
                                  const struct pel_ring_shape *ring)
{
    const bool legal = pel_point_legal(ring->center) &&
                       pel_radius_legal(ring->inner) &&
                       pel_radius_legal(ring->outer);
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels(&ring->center, 1, ring->outer));
    if (!legal || ring->outer <= ring->inner)
        return false;
    t->center = ring->center;
    t->radius[0] = ring->outer;
    t->radius[1] = ring->inner;
    t->spread.x = t->spread.y = 0;
    return pel_smooth_round_begin(t);
}

void pel_smooth_ring(const struct pel_surface *surface,
                     const struct pel_ring_shape *ring,
                     const struct pel_paint *paint)
{
    struct pel_smooth_round t;
    t.outline.smooth = (struct pel_smooth){surface, paint};
    if (begin(&t, ring))
        pel_smooth_round_paint(&t, true);
}
