#include "hit.h"

#include "hit_pixel.h"

bool pel_hit_rectangle(struct pel_point from, struct pel_point to, int32_t x,
                       int32_t y)
{
    struct pel_point p;
    return pel_hit_pixel(x, y, &p) && pel_point_legal(from) &&
           pel_point_legal(to) && from.x <= p.x && p.x < to.x &&
           from.y <= p.y && p.y < to.y;
}
