/* The walk down the two sides of a convex polygon, row by row, where flash and
 * stack are short (PEL_SMOOTH_TINY). It lives in one frame with what a paint is
 * given, and what is only needed to find pixels lies in the same memory. */
#ifndef PEL_SMOOTH_SHORT_WALK_H
#define PEL_SMOOTH_SHORT_WALK_H

#include "../base/divide.h"
#include "../raster/thick_line.h"
#include "smooth_edge.h"
#include "smooth_layer.h"

/* 64 bits, aligned to 4 where stack is short. */
typedef pel_dividend pel_smooth_far;

/* A side at the top of the row, or, where its edge begins in it, there. */
struct pel_smooth_short_side {
    pel_smooth_far at;   /* x, px 2^-32 */
    pel_smooth_far step; /* to the next row */
    uint32_t rise; /* its value: it is steep if the step is below a pixel */
    int32_t from;  /* the vertex that its edge begins at */
};

/* Of two sides the first is the left one. What is left of the present row
 * begins behind pixels.span: pixels that the left side crosses, or both sides,
 * then some that are alike, then some that the right side crosses. */
struct pel_smooth_short_walk {
    struct pel_smooth_pixels pixels;
    union {
        const struct pel_point *v;
        const struct pel_thick_line_shape *line;
    } shape;
    union {
        int32_t n;          /* vertices */
        struct pel_point m; /* of a line: from it to its first corner */
    } of;
    uint16_t left, alike, right;
    uint8_t height;     /* of the shape in the row, 1/256 px; 0: 256 */
    unsigned rows : 5;  /* from y on, that both sides cross as a whole */
    bool backwards : 1; /* its left side goes on to the next vertex */
    bool line : 1, square : 1;
    struct pel_smooth_short_side side[2];
    union {
        struct pel_smooth_drawing drawing;
        struct {
            struct pel_smooth_short_side side; /* followed through the row */
            struct pel_point edge[2];
            struct pel_smooth_piece piece;
            struct pel_span crossed; /* pixels */
            uint32_t area[PEL_SMOOTH_PIXELS];
        } row;
        struct pel_point v[4]; /* corners of a line, to begin with */
    } work;
};

/* Begins with the polygon or the line and the paint; v are the n vertices,
 * which are legal. False: nothing is to be seen. */
bool pel_smooth_short_begin(struct pel_smooth_short_walk *k,
                            const struct pel_surface *surface,
                            const struct pel_point *v, int32_t n);

/* Both sides from the first vertex at the top, which they have. The row above,
 * as if it were whole, is done. */
void pel_smooth_short_start(struct pel_smooth_short_walk *k);

/* Finds how many rows from y on edges of both sides cross as a whole, and end
 * below. False: no row is left. */
bool pel_smooth_look_down(struct pel_smooth_short_walk *k);

/* Follows side i through the row, and uses all that it has there. */
void pel_smooth_follow(struct pel_smooth_short_walk *k, int i, int32_t n);

/* Adds the areas right of a piece of side i in n pixels from x on, or takes
 * them away; where n is 0 it notes which columns it crosses, and its height. */
void pel_smooth_use_piece(struct pel_smooth_short_walk *k, int i, int32_t n);

/* What a side has in a row that it crosses as a whole. */
void pel_smooth_set_whole(const struct pel_smooth_short_side *side,
                          struct pel_smooth_piece *piece);

/* Not as structs, which small compilers copy by a call. */
static inline void pel_smooth_copy_side(
    struct pel_smooth_short_side *to, const struct pel_smooth_short_side *from)
{
    to->at = from->at;
    to->step = from->step;
    to->rise = from->rise;
    to->from = from->from;
}

/* Puts the pixels that were weighed last, and goes on until the paint is to be
 * asked. False at the end. */
bool pel_smooth_short_next(struct pel_smooth_short_walk *k);

/* Paints all rows, from the frame that has the walk. */
static PEL_ALWAYS_INLINE void pel_smooth_short_paint(
    struct pel_smooth_short_walk *k)
{
    pel_smooth_short_start(k);
    while (pel_smooth_short_next(k))
        pel_smooth_fill(&k->pixels, &k->work.drawing);
}

#endif
