/* The walk of rows through the cells of a gradient (gradient.h).
 *
 * A batch of rows is drawn a cell at a time, from left to right. A pixel lies
 * beyond the boundary where a cell ends when its error is 0 or more; the error
 * is a polynomial of x and y, so it is walked by additions: from pixel to
 * pixel, and from row to row, where the boundary has moved by a few pixels.
 * What lies before it in every row is one call to the format, with one colour.
 * Neighbours that are the same pixel value are one cell. */
#ifndef PEL_PAINT_CELLS_H
#define PEL_PAINT_CELLS_H

#include "../format/word.h"
#include "gradient.h"

/* PEL_CELL_STEP: a function of its own, for its stack, where code is to be
 * small. */
#if PEL_KNOW_SIDES
#define PEL_CELL_STEP inline
#else
#define PEL_CELL_STEP PEL_NOINLINE
#endif

/* Rows of a batch: one where code is to be small, and at most 32: then errors
 * of 32 bits do for all rows but the first. */
enum {
    PEL_CELL_ROWS = !PEL_KNOW_SIDES       ? 1
                    : PEL_BATCH_ROWS < 32 ? PEL_BATCH_ROWS
                                          : 32
};

/* The boundary where the present cell ends, at a pixel of the first row. Its
 * error grows by `step` to the next pixel. */
struct pel_boundary {
    int64_t error;
    int32_t x, step;
};

/* A batch of rows on its way through the cells. A cell's place is its number
 * from 0 on, and below the period where there is one. */
struct pel_cells {
    struct pel_boundary end; /* before the first: at a batch's first pixel */

    uint8_t left;   /* spans from `span` on */
    bool box;       /* hi ends all rows */
    bool opaque;    /* the next cell's colour is, */
    int8_t way;     /* from one cell's place to the next: 1 or -1 */
    int32_t hi;     /* runs end here at the farthest */
    uint32_t value; /* the opaque colour's pixel value, or the other colour */

    const struct pel_gradient *gradient;
    const struct pel_span *span; /* the shape's, of these rows */
    struct pel_spans cell;       /* the present cell's runs */

    int32_t place; /* of the next cell */
    int32_t limit; /* cells that may end yet; at 0 the rest is one cell */

    /* The kind's own: where the present cell begins, a radius or an angle, and
     * what the floor drops of it. */
    int32_t whole, rest;

#if PEL_KNOW_SIDES
    pel_color mask; /* of mixed colours what can be seen; 0: ask the format */
#endif

    /* The run of the present cell, in every row. */
    struct pel_span run[PEL_CELL_ROWS];
};

/* The place of the cell `part` of copy number `copy` of the way; of a padded
 * way copy >= 0. */
static inline int32_t pel_cells_place(const struct pel_gradient *g,
                                      int32_t copy, int32_t part)
{
    if (g->period == 0)
        return copy > 0 ? g->cells - 1 : part;
    return g->period > g->cells && (copy & 1) ? part + g->cells : part;
}

/* Before the first batch. */
void pel_cells_open(struct pel_cells *cells,
                    const struct pel_gradient *gradient,
                    const struct pel_spans *spans);

/* Goes on to the next batch, of at most `most` <= PEL_CELL_ROWS rows, unless
 * pixels are left of the present one: from end.x to hi. No limit, way 1. false
 * when none are. */
bool pel_cells_next(struct pel_cells *cells, int32_t most);

/* How many cells from the one at c->place on are the same pixel value as that;
 * 0: all that may come. Moves on to the first other one. */
int32_t pel_cells_pass(struct pel_cells *c);

/* Takes the colour of the cell at c->place. */
void pel_cells_color(struct pel_cells *c);

/* Ends all runs at the boundary. Its error grows by `row` to the pixel below;
 * `row` from row to row, and the step from pixel to pixel, by `bend`. true when
 * pixels are left. */
bool pel_cells_end(struct pel_cells *c, int32_t row, int32_t bend);

/* Ends all runs where their rows do: false, no pixels are left. */
bool pel_cells_end_all(struct pel_cells *c);

/* Draws what is left of every row up to hi, from the cell at c->place on. `end`
 * lets the present cell end where `count` >= 1 cells end, the present one
 * included, by pel_cells_end. true: pixels are left. Written out where it is
 * called, to spare the stack. */
static PEL_ALWAYS_INLINE void pel_cells_draw(
    struct pel_cells *c, bool (*end)(struct pel_cells *cells, int32_t count))
{
    bool rest = false;
    pel_cells_color(c);
    do {
        const uint32_t value = c->value;
        const bool opaque = c->opaque;
        const int32_t count = pel_cells_pass(c);
        if (count)
            rest = end(c, count);
        else
            rest = pel_cells_end_all(c);
        pel_fill_value(&c->cell, value, opaque);
    } while (rest);
}

#endif
