#include "hit.h"

#include "hit_pixel.h"

/* +1 or -1 when the side from a to b crosses the row of p, downwards or
 * upwards, on or left of p; else 0: the rule of raster/edge.h. The products are
 * below 2^49. */
static int32_t crossing(const struct pel_point *a, const struct pel_point *b,
                        struct pel_point p)
{
    int32_t winding = 1;
    if (a->y > b->y) {
        const struct pel_point *t = a;
        a = b;
        b = t;
        winding = -1;
    }
    if (p.y < a->y || p.y >= b->y)
        return 0;
    if (p.x < a->x && p.x < b->x)
        return 0;
    if (p.x >= a->x && p.x >= b->x)
        return winding;
    int64_t right = pel_product(p.x - a->x, b->y - a->y);
    int64_t edge = pel_product(p.y - a->y, b->x - a->x);
    return right >= edge ? winding : 0;
}

bool pel_hit_polygon(const struct pel_polygon_shape *polygon, int32_t x,
                     int32_t y)
{
    const struct pel_point *v = polygon->v;
    const int32_t n = polygon->n;
    struct pel_point p;
    if (n < 3 || !pel_hit_pixel(x, y, &p) || !pel_points_legal(v, n))
        return false;
    int32_t winding = 0;
    const struct pel_point *previous = &v[n - 1];
    for (int32_t i = 0; i < n; i++) {
        winding += crossing(previous, &v[i], p);
        previous = &v[i];
    }
    return polygon->rule == PEL_EVEN_ODD ? winding & 1 : winding != 0;
}

bool pel_hit_triangle(const struct pel_point v[3], int32_t x, int32_t y)
{
    const struct pel_polygon_shape polygon = {v, 3, PEL_NON_ZERO};
    return pel_hit_polygon(&polygon, x, y);
}
