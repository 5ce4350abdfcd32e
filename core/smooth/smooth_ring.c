#include "smooth_ring.h"

#include "round.h"

struct ring {
    struct pel_smooth_outline outline;
    struct pel_smooth_curve curve[2];
};

/* False: nothing is to be seen. */
static PEL_NOINLINE_32 bool begin(struct ring *t,
                                  const struct pel_surface *surface,
                                  const struct pel_ring_shape *ring,
                                  const struct pel_paint *paint)
{
    const bool legal = pel_point_legal(ring->center) &&
                       pel_radius_legal(ring->inner) &&
                       pel_radius_legal(ring->outer);
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels(&ring->center, 1, ring->outer));
    if (!legal || ring->outer <= ring->inner)
        return false;
    pel_smooth_round_set(&t->outline, t->curve, ring->center, ring->inner,
                         ring->outer);
    return pel_smooth_round_begin(surface, &t->outline, paint);
}

void pel_smooth_ring(const struct pel_surface *surface,
                     const struct pel_ring_shape *ring,
                     const struct pel_paint *paint)
{
    struct ring t;
    if (begin(&t, surface, ring, paint))
        pel_smooth_outline_paint(&t.outline);
}
