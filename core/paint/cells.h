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

/* PEL_CELL_STEP: a function of its own, for its stack, where code is to be
 * small. */
#if PEL_KNOW_SIDES
#define PEL_CELL_STEP inline
#else
#define PEL_CELL_STEP PEL_NOINLINE
#endif

/* Rows of a batch; few where stack is short. */
enum { PEL_CELL_ROWS = PEL_KNOW_SIDES ? PEL_BATCH_ROWS : 2 };

/* A batch of rows on its way through the cells. A cell's place is its number
 * from 0 on, and below the period where there is one. */
struct pel_cells {
    const struct pel_gradient *gradient;
    struct pel_spans cell;       /* the present cell's runs */
    const struct pel_span *span; /* the shape's, of these rows */

    int32_t stop;  /* runs end here, or where the shape's do */
    int32_t limit; /* cells that may end yet; at 0 the rest is one cell */
    int32_t step;  /* from one cell's place to the next: 1 or -1 */
    int32_t place; /* of the next cell */

    pel_color color; /* of the next cell */
#if PEL_KNOW_SIDES
    pel_color mask; /* bits of colours that the format shows; 0: any */
#endif

    /* The run of the present cell, in every row. */
    struct pel_span run[PEL_CELL_ROWS];
};

/* Before the first batch. */
void pel_cells_open(struct pel_cells *cells,
                    const struct pel_gradient *gradient,
                    const struct pel_spans *spans);

/* Goes on to the next batch, of at most `most` <= PEL_CELL_ROWS rows, unless
 * pixels are left of the present one. No stop, no limit, step 1. The first
 * pixel that is left; INT32_MAX: none. */
int32_t pel_cells_next(struct pel_cells *cells, const struct pel_spans *spans,
                       int32_t most);

/* How many cells from the one at c->place on are the same pixel value as that;
 * 0: all that may come. Moves on to the first other one. */
int32_t pel_cells_pass(struct pel_cells *c);

/* Before the first cell: its color, and a limit where the ramp is padded. */
void pel_cells_first(struct pel_cells *c);

/* Ends all runs at an edge, given at the first row, and left beyond the last.
 * true when pixels are left. */
bool pel_cells_end_at(struct pel_cells *c, struct pel_edge *edge);

/* Ends all runs where their rows do: false, no pixels are left. */
bool pel_cells_end_all(struct pel_cells *c);

/* Row i's next run ends before pixel x, which may lie anywhere. Negative when
 * pixels are left. */
static PEL_ALWAYS_INLINE int32_t pel_cells_end_run(struct pel_cells *c,
                                                   int32_t i, int32_t x)
{
    struct pel_span *run = &c->run[i];
    const int32_t end = pel_min(c->span[i].x1, c->stop);
    run->x0 = run->x1;
    run->x1 = pel_max(run->x1, pel_min(x, end));
    return run->x1 - end;
}

/* Draws what is left of every row up to `stop`, from the cell at c->place on.
 * `end` lets the present cell end where `count` >= 1 cells end, the present one
 * included: pel_cells_end_run for every row. true: pixels are left. Written out
 * where it is called, to spare the stack. */
static PEL_ALWAYS_INLINE void pel_cells_draw(
    struct pel_cells *c, bool (*end)(struct pel_cells *cells, int32_t count))
{
    bool rest = false;
    pel_cells_first(c);
    do {
        const pel_color present = c->color;
        const int32_t count = pel_cells_pass(c);
        if (count)
            rest = end(c, count);
        else
            rest = pel_cells_end_all(c);
        pel_fill_color(&c->cell, present);
    } while (rest);
}

#endif
