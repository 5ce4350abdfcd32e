#include "smooth_ring.h"

#include "round.h"

void pel_smooth_ring(const struct pel_surface *surface,
                     const struct pel_ring_shape *ring,
                     const struct pel_paint *paint)
{
    const bool legal = pel_point_legal(ring->center) &&
                       pel_radius_legal(ring->inner) &&
                       pel_radius_legal(ring->outer);
    const struct pel_smooth_round round = {ring->center, {0, 0}, ring->inner,
                                           ring->outer,  NULL,   NULL};
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels(&ring->center, 1, ring->outer));
    if (legal && ring->outer > ring->inner)
        pel_smooth_round(surface, &round, paint);
}
