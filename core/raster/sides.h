/* The sides of triangles and parallelograms, row by row: each is one edge or
 * two from the top down. */
#ifndef PEL_RASTER_SIDES_H
#define PEL_RASTER_SIDES_H

#include "edge.h"
#include "paint.h"

struct pel_side {
    struct pel_edge edge;
    const struct pel_point *end;  /* of the edge, */
    const struct pel_point *last; /* of the side */
};

/* A batch of spans, and the same as numbers: x0 and x1 of each. */
union pel_batch {
    struct pel_span span[PEL_ROWS];
    int32_t x[PEL_ROWS * 2];
};

/* Writes x of an edge in n rows to every other number of a batch. Edges are
 * walked one by one, so that the state of one stays in registers. */
static PEL_INLINE_LOOP void pel_edge_walk(struct pel_edge *edge, int32_t *x,
                                          int32_t n)
{
    struct pel_edge e = *edge;
    int32_t *const end = x + 2 * n;
    do {
        *x = e.x;
        x += 2;
        pel_edge_next(&e);
    } while (x < end);
    edge->x = e.x;
    edge->m = e.m;
}

/* Begins in row y, above `last`: the edge from `top` to `end`, or the next one
 * where that ends above y. */
static PEL_HOT void pel_side_start(struct pel_side *s,
                                   const struct pel_point *top, int32_t y)
{
    if (pel_first_pixel(s->end->y) <= y) {
        top = s->end;
        s->end = s->last;
    }
    pel_edge_start(&s->edge, top, s->end, y);
}

/* Walks n > 0 rows from y on, in which one edge may follow the other. Where a
 * batch begins at the bend, k is 0: what is written then is written again. */
static inline void pel_side_walk(struct pel_side *s, int32_t y, int32_t *x,
                                 int32_t n)
{
    for (;;) {
        int32_t k = pel_min(pel_first_pixel(s->end->y) - y, n);
        pel_edge_walk(&s->edge, x, k);
        n -= k;
        if (n == 0)
            return;
        x += 2 * k;
        y += k;
        pel_side_start(s, s->end, y);
    }
}

/* Orders the ends of spans, as either side may be the left one, and clips. */
static inline void pel_spans_order(struct pel_span *span, int32_t n,
                                   const struct pel_rect *clip)
{
    const int32_t left = clip->x0, right = clip->x1;
    do {
        int32_t a = span->x0, b = span->x1;
        span->x0 = pel_max(pel_min(a, b), left);
        span->x1 = pel_min(pel_max(a, b), right);
        span++;
    } while (--n);
}

#endif
