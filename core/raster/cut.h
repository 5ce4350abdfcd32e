/* Lines in pieces: the runs of one line, cut by holes and angles, on their way
 * to a paint. Smaller than a batch of lines (collect.h) on the stack of shapes
 * that walk several boundaries at once. */
#ifndef PEL_RASTER_CUT_H
#define PEL_RASTER_CUT_H

#include "paint.h"

/* Two parts of a line apart from each other, less one hole: the hole can split
 * one of them. */
enum { PEL_CUT_PIECES = 3 };

struct pel_cut {
    struct pel_spans spans;
    struct pel_span span[PEL_CUT_PIECES];
};

static inline void pel_cut_begin(struct pel_cut *c,
                                 const struct pel_surface *surface)
{
    c->spans = (struct pel_spans){surface, c->span, 0, 0, 0};
}

/* The pixels [x0, x1), if any, as piece n: how many there are then. */
static inline int32_t pel_cut_piece(struct pel_span *span, int32_t n,
                                    int32_t x0, int32_t x1)
{
    if (x0 >= x1)
        return n;
    span[n] = (struct pel_span){x0, x1};
    return n + 1;
}

/* Of n rows the pieces inside `run`, in their place: how many there are. */
static inline int32_t pel_cut_within(struct pel_span *span, int32_t n,
                                     const struct pel_span *run)
{
    int32_t pieces = 0;
    for (int32_t k = 0; k < n; k++)
        pieces = pel_cut_piece(span, pieces, pel_max(run->x0, span[k].x0),
                               pel_min(run->x1, span[k].x1));
    return pieces;
}

/* What is left of `run` without `hole`, as piece n and perhaps another; an
 * empty hole cuts nothing, wherever it lies. */
static inline int32_t pel_cut_hole(struct pel_span *span, int32_t n,
                                   const struct pel_span *run,
                                   const struct pel_span *hole)
{
    const struct pel_span r = *run, h = *hole;
    if (h.x0 >= h.x1)
        return pel_cut_piece(span, n, r.x0, r.x1);
    n = pel_cut_piece(span, n, r.x0, pel_min(r.x1, h.x0));
    return pel_cut_piece(span, n, pel_max(r.x0, h.x1), r.x1);
}

/* Takes `hole` from up to two pieces: it splits one of them at most. */
static inline int32_t pel_cut_take(struct pel_span *span, int32_t n,
                                   const struct pel_span *hole)
{
    const struct pel_span second = span[1];
    int32_t pieces = n > 0 ? pel_cut_hole(span, 0, &span[0], hole) : 0;
    return n > 1 ? pel_cut_hole(span, pieces, &second, hole) : pieces;
}

/* Paints the pieces as those of line y. */
static inline void pel_cut_paint(struct pel_cut *c,
                                 const struct pel_paint *paint, int32_t y)
{
    c->spans.y = y;
    if (c->spans.n)
        paint->fill(paint, &c->spans);
    c->spans.n = 0;
}

#endif
