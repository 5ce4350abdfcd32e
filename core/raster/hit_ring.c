#include "hit.h"

#include "hit_pixel.h"

bool pel_hit_ring(const struct pel_ring_shape *ring, int32_t x, int32_t y)
{
    struct pel_point p;
    if (!pel_hit_pixel(x, y, &p) || !pel_points_legal(&ring->center, 1) ||
        !pel_radius_legal(ring->inner) || !pel_radius_legal(ring->outer))
        return false;
    int64_t distance = pel_hit_distance(p, ring->center);
    return pel_square(ring->inner) < distance &&
           distance <= pel_square(ring->outer);
}
