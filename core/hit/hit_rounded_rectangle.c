#include "hit.h"

#include "hit_pixel.h"

/* v moved by the least amount into lo..hi. */
static int32_t nearest(int32_t v, int32_t lo, int32_t hi)
{
    return pel_max(lo, pel_min(v, hi));
}

bool pel_hit_rounded_rectangle(const struct pel_rounded_shape *rectangle,
                               int32_t x, int32_t y)
{
    const struct pel_point from = rectangle->from, to = rectangle->to;
    struct pel_point p;
    if (!pel_hit_rectangle(from, to, x, y) || !pel_hit_pixel(x, y, &p) ||
        !pel_radius_legal(rectangle->radius))
        return false;
    int32_t half = pel_min(to.x - from.x, to.y - from.y) / 2;
    int32_t r = pel_min(rectangle->radius, half);
    const struct pel_point inner = {nearest(p.x, from.x + r, to.x - r),
                                    nearest(p.y, from.y + r, to.y - r)};
    return pel_hit_disc(p, inner, r);
}
