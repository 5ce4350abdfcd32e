#include "hit_pixel.h"

#include "../base/trig.h"

/* The eighth of the turn, [k, k + 1) / 8, that a way leads into. */
static int32_t eighth_of(struct pel_point way)
{
    int32_t eighth = 0;
    if (way.y < 0 || (way.y == 0 && way.x < 0)) {
        eighth = 4;
        way.x = -way.x;
        way.y = -way.y;
    }
    if (way.x <= 0) {
        const int32_t x = way.x;
        eighth += 2;
        way.x = way.y;
        way.y = -x;
    }
    return eighth + (way.y >= way.x);
}

/* Does the way lie on the ray of an angle or, from angle 0 on, behind it?
 * Directions lie in the eighths of their angles, so the ray itself is needed in
 * its own eighth alone, where the two are less than a quarter turn apart. */
static bool is_behind(struct pel_point way, uint16_t turn)
{
    const int32_t eighth = eighth_of(way), of_ray = turn >> 13;
    if (eighth != of_ray)
        return eighth > of_ray;
    const struct pel_point ray = pel_direction(turn);
    return pel_product(ray.x, way.y) >= pel_product(ray.y, way.x);
}

bool pel_hit_wedge(struct pel_point center, uint16_t from, uint16_t to,
                   struct pel_point p)
{
    struct pel_point way = {p.x - center.x, p.y - center.y};
    if (way.x == 0 && way.y == 0)
        way.x = 1;
    if (from < to)
        return is_behind(way, from) && !is_behind(way, to);
    return from != to && (is_behind(way, from) || !is_behind(way, to));
}
