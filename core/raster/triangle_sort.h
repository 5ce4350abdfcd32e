/* Vertices from top to bottom; the first thing that every triangle does, so
 * that their order in the call changes nothing. */
#ifndef PEL_RASTER_TRIANGLE_SORT_H
#define PEL_RASTER_TRIANGLE_SORT_H

#include "../base/fixed.h"

static inline bool pel_above(const struct pel_point *a,
                             const struct pel_point *b)
{
    return a->y < b->y || (a->y == b->y && a->x < b->x);
}

static inline void pel_sort2(const struct pel_point **a,
                             const struct pel_point **b)
{
    if (pel_above(*b, *a)) {
        const struct pel_point *t = *a;
        *a = *b;
        *b = t;
    }
}

static inline void pel_sort3(const struct pel_point v[3],
                             const struct pel_point **top,
                             const struct pel_point **middle,
                             const struct pel_point **bottom)
{
    *top = &v[0];
    *middle = &v[1];
    *bottom = &v[2];
    pel_sort2(top, middle);
    pel_sort2(middle, bottom);
    pel_sort2(top, middle);
}

#endif
