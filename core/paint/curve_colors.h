/* The colours of a row's pieces where PEL_FAST_64BIT is 1: written out where
 * the function that makes knots is known. */
#ifndef PEL_PAINT_CURVE_COLORS_H
#define PEL_PAINT_CURVE_COLORS_H

#include "curve.h"

#if PEL_FAST_64BIT

#include "curve_piece.h"

/* The knot at (x, y) from the centre. */
typedef struct pel_knot pel_knot_function(const struct pel_curve *curve,
                                          int32_t x, int32_t y);

/* A run on its way to the right. */
struct pel_course {
    struct pel_curve_row row;
    pel_knot_function *knot;
    int32_t x, n;        /* what comes next, and how many pixels */
    struct pel_knot end; /* of the last piece, where it ended at x */
    int32_t log2;        /* of that piece; 0 where the next one begins anew */
    int32_t size, way;   /* of that piece, in pixels and sub-pixels */
    int64_t enough;      /* squares of dx from which on pieces of this size, */
    int64_t more;        /* and of twice this size, are far enough away */
};

static PEL_HOT struct pel_knot pel_course_knot(const struct pel_course *c,
                                               int32_t x)
{
    return c->knot(c->row.curve, pel_curve_way(&c->row, x), c->row.dy);
}

static PEL_HOT void pel_course_stay(struct pel_ramp_walk *w, uint64_t at)
{
    w->at = at;
    w->d1 = w->d2 = w->d3 = 0;
}

/* What is outside lies side by side, but for rows that it begins: so it is
 * looked for where a knot is. */
static PEL_HOT bool pel_course_outside(struct pel_course *c,
                                       struct pel_ramp_walk *w)
{
    if (c->end.value < c->row.curve->limit)
        return false;
    w->n = pel_curve_outside(&c->row, c->x, c->n);
    if (w->n == 0)
        return false;
    pel_course_stay(w, UINT64_C(1) << w->bits);
    w->inside = false;
    return true;
}

static PEL_HOT void pel_course_set_size(struct pel_course *c, int log2)
{
    c->log2 = log2;
    c->size = 1 << log2;
    c->way = 256 << log2;
    if (log2 == 0)
        return;
    const int32_t *least = c->row.curve->least + (log2 - PEL_PIECE_MIN_LOG2);
    c->enough = pel_square(least[0]) - c->row.square;
    c->more = INT64_MAX;
    if (log2 < PEL_PIECE_MAX_LOG2)
        c->more = pel_square(least[1]) - c->row.square;
}

/* The piece that holds the next pixel. */
static PEL_NOINLINE void pel_course_begin(struct pel_course *c,
                                          struct pel_ramp_walk *w)
{
    const uint64_t limit = c->row.curve->limit;
    const int log2 = pel_curve_piece(&c->row, c->x);
    const int32_t skip = c->x & ((1 << log2) - 1);
    pel_course_set_size(c, log2);
    const struct pel_knot a = pel_course_knot(c, c->x - skip);
    c->end = pel_course_knot(c, c->x - skip + c->size);
    w->n = pel_min(c->size - skip, c->n);
    w->inside = a.value < limit && (log2 == 0 || c->end.value < limit);
    pel_course_stay(w, a.value);
    if (log2 == 0)
        return;
    pel_curve_walk(w, &a, &c->end, log2);
    *w = pel_ramp_after(*w, skip);
}

/* Has the next piece the size of the last, which ended at x? What is left of
 * the centre or on it comes nearer, so pieces do not grow there, nor do they
 * shrink right of it; and one of twice the size begins at a multiple of that.
 */
static PEL_HOT bool pel_course_goes_on(const struct pel_course *c)
{
    const int32_t dx = pel_curve_way(&c->row, c->x);
    if (c->log2 == 0 || c->end.value >= c->row.curve->limit)
        return false;
    if (dx > 0)
        return pel_square(dx) < c->more || (c->x & c->size) != 0;
    return pel_square(pel_min(dx + c->way, 0)) >= c->enough;
}

static PEL_HOT void pel_course_take(struct pel_course *c,
                                    struct pel_ramp_walk *w)
{
    if (pel_course_goes_on(c)) {
        const struct pel_knot a = c->end;
        c->end = pel_course_knot(c, c->x + c->size);
        w->n = pel_min(c->size, c->n);
        w->inside = c->end.value < c->row.curve->limit;
        w->at = a.value;
        pel_curve_walk(w, &a, &c->end, c->log2);
    } else if (pel_course_outside(c, w)) {
        c->log2 = 0;
    } else {
        pel_course_begin(c, w);
    }
    c->x += w->n;
    c->n -= w->n;
}

static PEL_HOT struct pel_course pel_course_of(const struct pel_curve *curve,
                                               const struct pel_run *run)
{
    struct pel_course c;
    c.row = pel_curve_row_of(curve, run->y);
    c.x = run->x;
    c.n = run->n;
    c.end.value = UINT64_MAX; /* it may be outside */
    c.log2 = 0;
    return c;
}

/* A piece is prepared before the one to its left is coloured, so that the CPU
 * does both at once. `context` is for the curve's run function. */
static PEL_HOT void pel_course_colors(struct pel_course *c, const void *context,
                                      pel_color *colors)
{
    pel_curve_run *const run = c->row.curve->run;
    struct pel_ramp_walk walk[2], *w = &walk[0], *next = &walk[1], *t;
    w->bits = next->bits = c->row.curve->bits;
    pel_course_take(c, w);
    while (c->n > 0) {
        pel_course_take(c, next);
        run(context, w, colors);
        colors += w->n;
        t = w, w = next, next = t;
    }
    run(context, w, colors);
}

#endif
#endif
