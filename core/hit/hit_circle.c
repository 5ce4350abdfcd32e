#include "hit.h"

#include "hit_pixel.h"

bool pel_hit_circle(struct pel_point center, int32_t radius, int32_t x,
                    int32_t y)
{
    struct pel_point p;
    return pel_hit_pixel(x, y, &p) && pel_point_legal(center) &&
           pel_radius_legal(radius) && pel_hit_disc(p, center, radius);
}
