#include "hit.h"

#include "hit_pixel.h"

bool pel_hit_arc(const struct pel_arc_shape *arc, int32_t x, int32_t y)
{
    const struct pel_ring_shape ring = {arc->center, arc->inner, arc->outer};
    struct pel_point p;
    return pel_hit_pixel(x, y, &p) && pel_hit_ring(&ring, x, y) &&
           pel_hit_angle_range(arc->center, arc->from, arc->to, p);
}
