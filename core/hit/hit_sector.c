#include "hit.h"

#include "hit_pixel.h"

bool pel_hit_sector(const struct pel_sector_shape *sector, int32_t x, int32_t y)
{
    struct pel_point p;
    return pel_hit_pixel(x, y, &p) &&
           pel_hit_circle(sector->center, sector->radius, x, y) &&
           pel_hit_angle_range(sector->center, sector->from, sector->to, p);
}
