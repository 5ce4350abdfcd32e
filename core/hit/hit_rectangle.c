#include "hit.h"

#include "hit_pixel.h"

bool pel_hit_rectangle(struct pel_point from, struct pel_point to, int32_t x,
                       int32_t y)
{
    struct pel_point p;
    return pel_hit_pixel(x, y, &p) && pel_points_legal(&from, 1) &&
           pel_points_legal(&to, 1) && from.x <= p.x && p.x < to.x &&
           from.y <= p.y && p.y < to.y;
}
