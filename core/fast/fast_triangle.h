/* Triangles by 64-bit arithmetic: an edge is one 32.32 number and one addition
 * a row. The rows go to the paint's `fill`, unless its `fast` can write the
 * format of the surface and loops over them itself. Only triangles inside the
 * clip come here; coverage is exactly that of edge.h (proof: fast_triangle.c).
 */
#ifndef PEL_FAST_FAST_TRIANGLE_H
#define PEL_FAST_FAST_TRIANGLE_H

#include "../format/word.h"
#include "../raster/paint.h"

/* x >> 32 is the first pixel on or right of the edge in this row. */
struct pel_slope {
    int64_t x, step;
};

struct pel_fast_triangle {
    struct pel_slope whole;        /* top to bottom */
    struct pel_slope upper, lower; /* top to middle, middle to bottom */
    int32_t y0, y1, y2;            /* first rows of top, middle, bottom */
};

/* The rows of a triangle for the loop of a writer, in registers. */
struct pel_fast_walk {
    struct pel_slope whole, half, lower;
    int32_t y, stop, end; /* stop: where the short edge ends */
    uintptr_t row, pitch; /* address of column 0; see pel_column_zero */
};

static PEL_ALWAYS_INLINE struct pel_fast_walk pel_fast_walk_begin(
    const struct pel_surface *s, const struct pel_fast_triangle *t,
    int pixel_bytes)
{
    struct pel_fast_walk w = {t->whole, t->upper, t->lower, t->y0,
                              t->y1,    t->y2,    0,        0};
    w.pitch = (uintptr_t)(ptrdiff_t)s->stride;
    w.row = pel_column_zero(s, t->y0, pixel_bytes) - w.pitch;
    return w;
}

/* Moves to the next row, at w->row: n >= 0 pixels from x on. */
static PEL_ALWAYS_INLINE bool pel_fast_walk_next(struct pel_fast_walk *w,
                                                 int32_t *x, int32_t *n)
{
    if (w->y == w->stop) {
        if (w->y == w->end)
            return false;
        w->stop = w->end;
        w->half = w->lower;
    }
    int32_t p = (int32_t)(w->whole.x >> 32), q = (int32_t)(w->half.x >> 32);
    w->whole.x += w->whole.step;
    w->half.x += w->half.step;
    *x = p < q ? p : q;
    *n = (p < q ? q : p) - *x;
    w->row += w->pitch;
    w->y++;
    return true;
}

#endif
