/* The walk down the two sides of a convex polygon, some rows at a time; where
 * PEL_SMOOTH_TINY is 1 the one of short_walk.h takes its place. */
#ifndef PEL_SMOOTH_SMOOTH_WALK_H
#define PEL_SMOOTH_SMOOTH_WALK_H

#include "smooth.h"
#include "smooth_edge.h"

/* Pixels of a row whose areas are summed at a time, each a byte of a batch. */
enum { PEL_SMOOTH_SUMS = PEL_64BIT && !PEL_SMOOTH_TINY ? 32 : 6 };
PEL_STATIC_ASSERT(pel_smooth_sums_fit,
                  (int)PEL_SMOOTH_SUMS <= (int)PEL_SMOOTH_BATCH_BYTES);

/* An edge, by its vertices; the same: the chain has ended. */
struct pel_smooth_vertices {
    int32_t from, to;
};

struct pel_smooth_chain {
    int64_t at;   /* x at the top of the row or of the edge, px 2^-32 */
    int64_t step; /* to the next row */
    struct pel_rise rise;
    struct pel_smooth_vertices edge;
};

/* What a side was at the top of a row. */
struct pel_smooth_above {
    int32_t x; /* px 2^-16 */
    struct pel_rise rise;
    int32_t from; /* where its edge begins */
};

/* Of two the first is the left side. */
struct pel_smooth_walk {
    struct pel_smooth smooth;
    const struct pel_point *v;
    int32_t n;
    int32_t y, end;       /* rows to come */
    struct pel_span rest; /* columns of the row above them that are left */
    int8_t turn;          /* 1 or -1, to the next vertex of the right side */
    bool inside;          /* no column is clipped away */
    uint8_t rows;         /* that a batch has room for, .. */
    int32_t whole; /* .. above this one, of those that edges cross as a whole */
    struct pel_smooth_chain side[2];
    union {
        struct pel_smooth_batch batch;
        struct {
            int32_t y, n;
            uint8_t count[2 * PEL_SMOOTH_BATCH_ROWS];
            uint8_t coverage[PEL_SMOOTH_BATCH_BYTES];
            struct pel_span full; /* up to here a batch of one row */
            struct pel_smooth_above above[2];
        } row;
    } of;
};

/* On to the next edge of side i that goes down, if there is one. */
void pel_smooth_next_edge(struct pel_smooth_walk *k, int i);

/* Moves a side down by h / 256 px. The part of a step is rounded towards 0: it
 * does not pass its end. h is less than the edge is high, or 256, so the
 * product is below 2^24 2^32. */
void pel_smooth_go_down(struct pel_smooth_chain *s, int32_t h);

/* How many rows that both sides cross a batch has room for; 0 where they cross
 * too many pixels. */
int32_t pel_smooth_room(const struct pel_smooth_walk *k);

/* Makes a batch of n such rows from k->y on, and moves on: reads only smooth,
 * inside and the sides' first three members. */
void pel_smooth_cross(struct pel_smooth_walk *k, int32_t n);

/* Moves on by a row that vertices lie in or a side crosses in many pixels. Of
 * what is left of it, if it is something, the other one makes a batch, bit by
 * bit. */
void pel_smooth_pass_row(struct pel_smooth_walk *k);
void pel_smooth_rest_of_row(struct pel_smooth_walk *k);

#endif
