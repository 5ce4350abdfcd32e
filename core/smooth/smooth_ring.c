#include "smooth_ring.h"

#include "round.h"

void pel_smooth_ring(const struct pel_surface *surface,
                     const struct pel_ring_shape *ring,
                     const struct pel_paint *paint)
{
    const bool legal = pel_point_legal(ring->center) &&
                       pel_radius_legal(ring->inner) &&
                       pel_radius_legal(ring->outer);
    struct pel_smooth_outline outline;
    struct pel_smooth_curve curve[2];
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels(&ring->center, 1, ring->outer));
    if (!legal || ring->outer <= ring->inner)
        return;
    pel_smooth_round_set(&outline, curve, ring->center, ring->inner,
                         ring->outer);
    if (pel_smooth_round_begin(surface, &outline, paint))
        pel_smooth_outline_paint(&outline);
}
