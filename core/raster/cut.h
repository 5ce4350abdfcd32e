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
    struct pel_rows rows;
    struct pel_row row[PEL_CUT_PIECES];
};

static inline void pel_cut_begin(struct pel_cut *c,
                                 const struct pel_surface *surface)
{
    c->rows = (struct pel_rows){surface, c->row, 0, 0, 0};
}

/* The pixels [x0, x1), if any, as piece n: how many there are then. */
static inline int32_t pel_cut_piece(struct pel_row *row, int32_t n, int32_t x0,
                                    int32_t x1)
{
    if (x0 >= x1)
        return n;
    row[n] = (struct pel_row){x0, x1};
    return n + 1;
}

/* Of n rows the pieces inside `run`, in their place: how many there are. */
static inline int32_t pel_cut_within(struct pel_row *row, int32_t n,
                                     const struct pel_row *run)
{
    int32_t pieces = 0;
    for (int32_t k = 0; k < n; k++)
        pieces = pel_cut_piece(row, pieces, pel_max(run->x0, row[k].x0),
                               pel_min(run->x1, row[k].x1));
    return pieces;
}

/* What is left of `run` without `hole`, as piece n and perhaps another; an
 * empty hole cuts nothing, wherever it lies. */
static inline int32_t pel_cut_hole(struct pel_row *row, int32_t n,
                                   const struct pel_row *run,
                                   const struct pel_row *hole)
{
    const struct pel_row r = *run, h = *hole;
    if (h.x0 >= h.x1)
        return pel_cut_piece(row, n, r.x0, r.x1);
    n = pel_cut_piece(row, n, r.x0, pel_min(r.x1, h.x0));
    return pel_cut_piece(row, n, pel_max(r.x0, h.x1), r.x1);
}

/* Takes `hole` from up to two pieces: it splits one of them at most. */
static inline int32_t pel_cut_take(struct pel_row *row, int32_t n,
                                   const struct pel_row *hole)
{
    const struct pel_row second = row[1];
    int32_t pieces = n > 0 ? pel_cut_hole(row, 0, &row[0], hole) : 0;
    return n > 1 ? pel_cut_hole(row, pieces, &second, hole) : pieces;
}

/* Paints the pieces as those of line y. */
static inline void pel_cut_paint(struct pel_cut *c,
                                 const struct pel_paint *paint, int32_t y)
{
    c->rows.y = y;
    if (c->rows.n)
        paint->fill(paint, &c->rows);
    c->rows.n = 0;
}

#endif
