#include "hit.h"

#include "hit_pixel.h"

bool pel_hit_ring(const struct pel_ring_shape *ring, int32_t x, int32_t y)
{
    struct pel_point p;
    return pel_hit_pixel(x, y, &p) && pel_point_legal(ring->center) &&
           pel_radius_legal(ring->inner) && pel_radius_legal(ring->outer) &&
           pel_hit_disc(p, ring->center, ring->outer) &&
           !pel_hit_disc(p, ring->center, ring->inner);
}
