#include "hit_pixel.h"

#include "../base/trig.h"
#include "../round/angle_range.h"

/* The eighth of the turn, [k, k + 1) / 8, that holds the direction d. */
static int32_t eighth_of(struct pel_point d)
{
    int32_t eighth = 0;
    if (d.y < 0 || (d.y == 0 && d.x < 0)) {
        eighth = 4;
        d.x = -d.x;
        d.y = -d.y;
    }
    if (d.x <= 0) {
        const int32_t x = d.x;
        eighth += 2;
        d.x = d.y;
        d.y = -x;
    }
    return eighth + (d.y >= d.x);
}

/* True when d lies on the ray of an angle or clockwise of it, up to angle 0.
 * Rays lie in the eighths of their angles, so the ray itself is needed in its
 * own eighth only, where the two are less than a quarter turn apart. */
static bool is_behind(struct pel_point d, uint16_t turn)
{
    const int32_t eighth = eighth_of(d), of_ray = turn >> 13;
    if (eighth != of_ray)
        return eighth > of_ray;
    const struct pel_point ray = pel_direction(turn);
    return pel_product(ray.x, d.y) >= pel_product(ray.y, d.x);
}

bool pel_hit_angle_range(struct pel_point center, int32_t from, int32_t to,
                         struct pel_point p)
{
    struct pel_angles a;
    struct pel_point d = {p.x - center.x, p.y - center.y};
    if (d.x == 0 && d.y == 0)
        d.x = 1;
    if (!pel_angles_set(&a, from, to))
        return false;
    if (a.from < a.to)
        return is_behind(d, a.from) && !is_behind(d, a.to);
    return is_behind(d, a.from) || !is_behind(d, a.to);
}
