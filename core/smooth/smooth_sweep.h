/* Polygons that may cross themselves: rows are cut where an edge begins, ends
 * or crosses another. */
#ifndef PEL_SMOOTH_SMOOTH_SWEEP_H
#define PEL_SMOOTH_SMOOTH_SWEEP_H

#include "../raster/polygon.h"
#include "smooth_edge.h"
#include "smooth_layer.h"

/* The units of a row's height, 2^-16 px, in which it is cut; and pixels that
 * are painted at a time, beside full ones. */
enum {
    PEL_SMOOTH_ROW = 65536,
#if PEL_SMOOTH_TINY
    PEL_SMOOTH_SWEEP_PIXELS = PEL_SMOOTH_PIXELS
#else
    PEL_SMOOTH_SWEEP_PIXELS = PEL_64BIT ? 64 : 16
#endif
};

struct pel_smooth_edge {
    int64_t at; /* x at the top of the row, px 2^-32, even if it begins below */
    int64_t step; /* to the next row */
    struct pel_rise rise;
    int32_t top, bottom; /* y, sub-pixels */
    int32_t x0, x1;      /* px 2^-16, at the top and the bottom of a part */
    int32_t winding;     /* 1 downwards, -1 upwards */
    uint16_t begin, end; /* of the present row, 256ths */
};

/* The head of scratch memory, as stacks are small: order[0, active) are the
 * edges that touch the row, order[active, count) those to come, by their top.
 */
struct pel_smooth_sweep {
    struct pel_smooth smooth;
    struct pel_smooth_edge *edge;
    int32_t *order;
    int32_t *sum; /* differences of areas from pixel to pixel, in 2^-22 of 1/255
                     px^2; from the clip's left side on, one more at the end */
    int32_t count, active;
    int32_t room;    /* edges that there is memory for */
    int32_t mask;    /* of the winding number: 1 even-odd, -1 non-zero */
    int32_t y0, y1;  /* rows that are drawn */
    int32_t lo, end; /* px that `sum` is not 0 in */
    int32_t area;    /* of the pixel up to which it has been taken */
    struct pel_smooth_row row; /* pixels of it that are painted next */
    uint8_t coverage[PEL_SMOOTH_SWEEP_PIXELS];
#if PEL_SMOOTH_TINY
    struct pel_span span;
    struct pel_smooth_drawing *drawing; /* memory for one */
#endif
};

/* After pel_smooth_begin of w->smooth: with memory for the edges and the row,
 * as PEL_SMOOTH_POLYGON_SCRATCH_SIZE counts it. Clears the sums; after a sweep
 * they are 0 again. */
void pel_smooth_sweep_begin(struct pel_smooth_sweep *w, void *edges,
                            int32_t room, enum pel_fill_rule rule);

/* Then, before the first edge: the rows, inside the clip. */
static inline void pel_smooth_sweep_set_rows(struct pel_smooth_sweep *w,
                                             int32_t y0, int32_t y1)
{
    w->count = w->active = 0;
    w->y0 = y0;
    w->y1 = y1;
}

/* Adds the edge from a to b, of legal points, if it touches a row that is
 * drawn. False: there is no room for it. */
bool pel_smooth_sweep_add(struct pel_smooth_sweep *w, const struct pel_point *a,
                          const struct pel_point *b);

/* Draws fewer rows, up to y1: forgets edges below. */
void pel_smooth_sweep_cut(struct pel_smooth_sweep *w, int32_t y1);

/* Paints what is inside the edges of a closed outline. There are none any more
 * then. */
void pel_smooth_sweep_paint(struct pel_smooth_sweep *w);

/* Adds what is inside in the row at hand, of the edges that touch it. */
void pel_smooth_add_row(struct pel_smooth_sweep *w);

#endif
