/* The walk down the two sides of a convex polygon. */
#ifndef PEL_SMOOTH_SMOOTH_WALK_H
#define PEL_SMOOTH_SMOOTH_WALK_H

#include "smooth.h"
#include "smooth_edge.h"

/* Pixels that a side may cross in a row that is walked in whole. */
enum { PEL_SMOOTH_WIDE = PEL_64BIT ? 32 : 8 };

struct pel_smooth_side {
    int64_t at;   /* x at the top of the row or of the edge, px 2^-32 */
    int64_t step; /* to the next row */
    struct pel_rise rise;
    int32_t from, to; /* vertices of the edge; the same: the chain has ended */
    int32_t turn;     /* 1 or -1 */
};

struct pel_smooth_walk {
    struct pel_smooth smooth;
    const struct pel_point *v;
    int32_t n, bottom;              /* bottom: the lowest y */
    bool inside;                    /* the clip, left and right */
    struct pel_smooth_side side[2]; /* left, right */
};

/* h / 256 of a step, towards 0: a side does not pass its end. h is less than
 * the edge is high, so the product is below 2^24 2^32. */
static inline int64_t pel_smooth_part(int64_t step, int32_t h)
{
    const int64_t size =
        (int64_t)(pel_times((uint64_t)pel_size_of(step), h) >> 8);
    return step < 0 ? -size : size;
}

static inline int32_t pel_smooth_next_vertex(const struct pel_smooth_walk *k,
                                             int32_t i, int32_t turn)
{
    i += turn;
    return i == k->n ? 0 : i < 0 ? k->n - 1 : i;
}

/* On to the next edge that goes down; false at the end of the chain. */
bool pel_smooth_next_edge(const struct pel_smooth_walk *k,
                          struct pel_smooth_side *s);

/* Paints n rows from y on that both sides cross, each in few pixels, from where
 * they are, and moves them on: reads only smooth, inside and the sides' first
 * three members. */
void pel_smooth_cross_rows(struct pel_smooth_walk *k, int32_t y, int32_t n);

/* Paints a row that vertices lie in, or that a side crosses in many pixels, and
 * moves on to the next. */
void pel_smooth_vertex_row(struct pel_smooth_walk *k, int32_t y);

#endif
