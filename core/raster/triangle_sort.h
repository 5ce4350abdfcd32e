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

/* A point as a number with the order of pel_above: minimum and maximum of two
 * need no branch. */
static inline int64_t pel_point_key(const struct pel_point *p)
{
    return p->y * INT64_C(4294967296) + (int64_t)((uint32_t)p->x ^ 0x80000000u);
}

/* pel_above: by y, and by x at one y. pel_topmost: which vertex is above the
 * others; planes over a triangle are anchored there. 64-bit CPUs compare both
 * coordinates as one number, without branches that cannot be predicted. */
#if PEL_64BIT
static inline bool pel_above(const struct pel_point *a,
                             const struct pel_point *b)
{
    return a->y * INT64_C(4294967296) + a->x <
           b->y * INT64_C(4294967296) + b->x;
}

static inline int pel_topmost(const struct pel_point v[3])
{
    const int64_t a = pel_point_key(&v[0]), b = pel_point_key(&v[1]),
                  c = pel_point_key(&v[2]);
    const int second = b < a, third = c < (b < a ? b : a);
    return (second & ~third) + 2 * third;
}
#else
static inline bool pel_above(const struct pel_point *a,
                             const struct pel_point *b)
{
    return a->y < b->y || (a->y == b->y && a->x < b->x);
}

static inline int pel_topmost(const struct pel_point v[3])
{
    const int i = pel_above(&v[1], &v[0]) ? 1 : 0;
    return pel_above(&v[2], &v[i]) ? 2 : i;
}
#endif

/* pel_triangle_area of legal vertices. */
static inline int64_t pel_area_of(const struct pel_point v[3])
{
    return pel_product(v[1].x - v[0].x, v[2].y - v[0].y) -
           pel_product(v[2].x - v[0].x, v[1].y - v[0].y);
}

static inline void pel_sort3(const struct pel_point *p[3])
{
    for (int i = 0; i < 3; i++)
        if (pel_above(p[(i & 1) + 1], p[i & 1]))
            pel_swap_points(&p[i & 1], &p[(i & 1) + 1]);
}

#endif
