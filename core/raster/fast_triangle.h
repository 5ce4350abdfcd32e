/* Triangles on 64-bit CPUs: an edge is one 32.32 number and one addition a row.
 * A paint that has a writer for the surface's format owns the row loop, so that
 * there is one indirect call per triangle. Only triangles that the clip does
 * not touch come here; coverage is the same as that of edge.h, pixel for pixel,
 * by the two bounds below. */
#ifndef PEL_RASTER_FAST_TRIANGLE_H
#define PEL_RASTER_FAST_TRIANGLE_H

#include "paint.h"

#if PEL_FAST_64BIT

/* x >> 32 is the first pixel on or right of the edge in this row. */
struct pel_slope {
    int64_t x, step;
};

struct pel_fast_triangle {
    struct pel_slope whole;        /* top to bottom */
    struct pel_slope upper, lower; /* top to middle, middle to bottom */
    int32_t y0, y1, y2;            /* first rows of top, middle, bottom */
};

/* The loop of a writer: x and n of each row. `t` is the writer's own copy. */
static inline int32_t pel_fast_next(struct pel_slope *a, struct pel_slope *b,
                                    int32_t *n)
{
    int32_t p = (int32_t)(a->x >> 32), q = (int32_t)(b->x >> 32);
    a->x += a->step;
    b->x += b->step;
    *n = p < q ? q - p : p - q;
    return p < q ? p : q;
}

/* Tries to draw a legal triangle; true when that is done, or it is empty. */
bool pel_fast_triangle(const struct pel_surface *surface,
                       const struct pel_point v[3],
                       const struct pel_paint *paint);

#else

#define pel_fast_triangle(surface, v, paint) false

#endif
#endif
