#include "hit_pixel.h"

#include "../base/fixed_trig.h"

/* |a| <= 2^15 and |b| < 2^25 in each coordinate. */
static int64_t cross(struct pel_point a, struct pel_point b)
{
    return (int64_t)a.x * b.y - (int64_t)a.y * b.x;
}

static int64_t dot(struct pel_point a, struct pel_point b)
{
    return (int64_t)a.x * b.x + (int64_t)a.y * b.y;
}

bool pel_hit_wedge(struct pel_point center, uint16_t from, uint16_t to,
                   struct pel_point p)
{
    const bool large = (uint16_t)(to - from) > 32768;
    const struct pel_point first = pel_direction(large ? to : from);
    const struct pel_point last = pel_direction(large ? from : to);
    struct pel_point at = {p.x - center.x, p.y - center.y};
    if (from == to)
        return false;
    if (at.x == 0 && at.y == 0)
        at.x = 1;
    int64_t side = cross(first, at);
    bool inside =
        (side > 0 && cross(last, at) < 0) || (side == 0 && dot(first, at) > 0);
    return inside != large;
}
