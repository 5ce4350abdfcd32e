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
    const struct pel_paint *paint;
    struct pel_rows rows;
    struct pel_row row[PEL_CUT_PIECES];
};

static inline void pel_cut_begin(struct pel_cut *c,
                                 const struct pel_surface *surface,
                                 const struct pel_paint *paint)
{
    c->paint = paint;
    c->rows = (struct pel_rows){surface, c->row, 0, 0, 0};
}

static inline void pel_cut_piece(struct pel_cut *c, int32_t x0, int32_t x1)
{
    if (x0 < x1)
        c->row[c->rows.n++] = (struct pel_row){x0, x1};
}

/* What is left of `run` without `hole`; an empty hole cuts nothing, wherever
 * it lies. Up to two pieces. */
static inline void pel_cut_hole(struct pel_cut *c, const struct pel_row *run,
                                const struct pel_row *hole)
{
    const bool whole = hole->x0 >= hole->x1;
    pel_cut_piece(c, run->x0, whole ? run->x1 : pel_min(run->x1, hole->x0));
    if (!whole)
        pel_cut_piece(c, pel_max(run->x0, hole->x1), run->x1);
}

/* Paints the pieces as those of line y. */
static inline void pel_cut_paint(struct pel_cut *c, int32_t y)
{
    c->rows.y = y;
    if (c->rows.n)
        c->paint->fill(c->paint, &c->rows);
    c->rows.n = 0;
}

#endif
