/* The corners of a triangle as its planes need them. */
#ifndef PEL_RASTER_CORNERS_H
#define PEL_RASTER_CORNERS_H

#include "plane.h"
#include "triangle_sort.h"

/* Of equally high vertices the left one. 64-bit CPUs compare both coordinates
 * as one number, without branches that cannot be predicted. */
static inline int pel_topmost(const struct pel_point v[3])
{
    if (PEL_64BIT) {
        const int64_t a = pel_point_key(&v[0]), b = pel_point_key(&v[1]),
                      c = pel_point_key(&v[2]);
        const int second = b < a, third = c < (b < a ? b : a);
        return (second & ~third) + 2 * third;
    }
    const int i = pel_above(&v[1], &v[0]);
    return pel_above(&v[2], &v[i]) ? 2 : i;
}

/* pel_plane_corners, where a call is too much. */
static inline void pel_corners_set(struct pel_plane_setup *setup,
                                   const struct pel_point v[3])
{
    struct pel_plane_setup *s = setup;
    int32_t bx = v[1].x - v[0].x, by = v[1].y - v[0].y;
    int32_t cx = v[2].x - v[0].x, cy = v[2].y - v[0].y;
    const int64_t area = pel_product(bx, cy) - pel_product(cx, by);
    const int32_t sign = (int32_t)(area >> 63) | (area != 0);
    bx *= sign;
    by *= sign;
    cx *= sign;
    cy *= sign;
    s->right[0] = by - cy;
    s->right[1] = cy;
    s->right[2] = -by;
    s->down[0] = cx - bx;
    s->down[1] = -cx;
    s->down[2] = bx;
    s->area = (uint64_t)pel_size_of(area);
    s->first = (uint8_t)pel_topmost(v);
    s->a = v[s->first];
}

#endif
