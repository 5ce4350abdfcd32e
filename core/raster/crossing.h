/* Does a side of an outline pass a point? */
#ifndef PEL_RASTER_CROSSING_H
#define PEL_RASTER_CROSSING_H

#include "../base/point.h"

/* +1 or -1 when the side from a to b crosses the row of p, downwards or
 * upwards, on or left of p; else 0: the rule of raster/edge.h. The products are
 * below 2^49. */
static inline int32_t pel_crossing(const struct pel_point *a,
                                   const struct pel_point *b,
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

#endif
