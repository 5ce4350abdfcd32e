#include "hit.h"

#include "hit_pixel.h"

bool pel_hit_circle(struct pel_point center, int32_t radius, int32_t x,
                    int32_t y)
{
    struct pel_point p;
    return pel_hit_pixel(x, y, &p) && pel_point_legal(center) &&
           pel_radius_legal(radius) && pel_hit_disc(p, center, radius);
}

bool pel_hit_ring(const struct pel_ring_shape *ring, int32_t x, int32_t y)
{
    struct pel_point p;
    return pel_hit_pixel(x, y, &p) && pel_point_legal(ring->center) &&
           pel_radius_legal(ring->inner) && pel_radius_legal(ring->outer) &&
           pel_hit_disc(p, ring->center, ring->outer) &&
           !pel_hit_disc(p, ring->center, ring->inner);
}

bool pel_hit_sector(const struct pel_sector_shape *sector, int32_t x, int32_t y)
{
    struct pel_point p;
    return pel_hit_pixel(x, y, &p) &&
           pel_hit_circle(sector->center, sector->radius, x, y) &&
           pel_hit_angle_range(sector->center, sector->from, sector->to, p);
}

bool pel_hit_arc(const struct pel_arc_shape *arc, int32_t x, int32_t y)
{
    const struct pel_ring_shape ring = {arc->center, arc->inner, arc->outer};
    struct pel_point p;
    return pel_hit_pixel(x, y, &p) && pel_hit_ring(&ring, x, y) &&
           pel_hit_angle_range(arc->center, arc->from, arc->to, p);
}
