/* The walk of a batch of rows through the cells of a gradient (gradient.h).
 *
 * A batch of rows is drawn a cell at a time, from left to right: the boundary
 * where the cell ends is walked down the rows by compare and carry, as an edge
 * or a circle is. What lies before it in every row is one call to the format,
 * with one colour. Neighbours that are the same pixel value are one cell. */
#ifndef PEL_PAINT_CELLS_H
#define PEL_PAINT_CELLS_H

#include "../format/word.h"
#include "../raster/edge.h"
#include "gradient.h"

/* A batch of rows on its way through the cells. A cell's place is its number
 * from 0 on, and below the period where there is one. */
struct pel_cells {
    const struct pel_gradient *gradient;
    const struct pel_spans *spans; /* the shape's */
    struct pel_span all;           /* from their first pixel to their last */

    int32_t stop;  /* runs end here, or where the shape's do */
    int32_t limit; /* so many cells may end; what is left is one cell */
    int32_t step;  /* from one cell's place to the next: 1 or -1 */
    int32_t place; /* of the next cell */
    bool rest;     /* has any row pixels left? */

    pel_color color; /* of the next cell */
    pel_color mask;  /* bits of colours that the format shows; 0: any */

    /* The run of the present cell, in every row. */
    struct pel_span run[PEL_BATCH_ROWS];
};

/* Sets gradient, rows, all, mask and run: none has begun. No stop, no limit.
 * false: there is no pixel. */
bool pel_cells_begin(struct pel_cells *cells,
                     const struct pel_gradient *gradient,
                     const struct pel_spans *spans);

/* How many cells from the one at c->place on are the same pixel value as that;
 * 0: all that may come. Moves on to the first other one. */
int32_t pel_cells_pass(struct pel_cells *c);

/* Before the first cell: its color, and a limit where the ramp is padded. */
void pel_cells_first(struct pel_cells *c);

/* Row i's next run ends before pixel x, which may lie anywhere. Negative when
 * pixels are left. */
static PEL_ALWAYS_INLINE int32_t pel_cells_end_run(struct pel_cells *c,
                                                   int32_t i, int32_t x)
{
    struct pel_span *run = &c->run[i];
    const int32_t end = pel_min(c->spans->span[i].x1, c->stop);
    run->x0 = run->x1;
    run->x1 = pel_max(run->x1, pel_min(x, end));
    return run->x1 - end;
}

/* Ends all runs at an edge, given at the first row, and left beyond the last.
 */
static PEL_ALWAYS_INLINE void pel_cells_end_at(struct pel_cells *c,
                                               struct pel_edge *edge)
{
    const int32_t n = c->spans->n, step = c->spans->step;
    int32_t rest = 0;
    for (int32_t i = 0; i < n; i++) {
        rest |= pel_cells_end_run(c, i, edge->x);
        if (step)
            pel_edge_next(edge);
    }
    c->rest = rest < 0;
}

/* Draws what is left of every row up to `stop`, from the cell at c->place on.
 * `end` lets the present cell end where `count` >= 1 cells end, the present one
 * included: pel_cells_end_run for every row, and `rest`. Written out where it
 * is called, to spare the stack. */
static PEL_ALWAYS_INLINE void pel_cells_draw(
    struct pel_cells *c, void (*end)(struct pel_cells *cells, int32_t count))
{
    const struct pel_spans cell = {c->spans->surface, c->run, c->spans->y,
                                   c->spans->n, c->spans->step};
    pel_cells_first(c);
    do {
        const pel_color present = c->color;
        const int32_t count = pel_cells_pass(c);
        c->rest = false;
        if (count)
            end(c, count);
        else
            for (int32_t i = 0; i < cell.n; i++)
                pel_cells_end_run(c, i, INT32_MAX);
        pel_fill_color(&cell, present);
    } while (c->rest);
}

/* Hands the rows to `draw` in parts of at most `width` pixels of one row. */
void pel_gradient_parts(const struct pel_gradient *gradient,
                        const struct pel_spans *spans, int32_t width,
                        void (*draw)(const struct pel_gradient *gradient,
                                     const struct pel_spans *spans));

#endif
