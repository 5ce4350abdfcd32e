/* Sorts vertices from top to bottom: their order in a call changes nothing. */
#ifndef PEL_RASTER_TRIANGLE_SORT_H
#define PEL_RASTER_TRIANGLE_SORT_H

#include "../base/point.h"

static inline void pel_swap_points(const struct pel_point **a,
                                   const struct pel_point **b)
{
    const struct pel_point *t = *a;
    *a = *b;
    *b = t;
}

/* By y alone: enough where only edges matter. */
static inline void pel_sort_rows(const struct pel_point *p[3])
{
    const struct pel_point *a = p[0], *b = p[1], *c = p[2];
    if (b->y < a->y)
        pel_swap_points(&a, &b);
    if (c->y < b->y)
        pel_swap_points(&b, &c);
    if (b->y < a->y)
        pel_swap_points(&a, &b);
    p[0] = a;
    p[1] = b;
    p[2] = c;
}

/* By y, and by x at one y. */
static inline bool pel_above(const struct pel_point *a,
                             const struct pel_point *b)
{
    if (PEL_64BIT)
        return a->y * INT64_C(4294967296) + a->x <
               b->y * INT64_C(4294967296) + b->x;
    return a->y < b->y || (a->y == b->y && a->x < b->x);
}

#endif
