/* How the rows of a gradient are filled, cell by cell or pixel by pixel
 * (cells.h). */
#ifndef PEL_PAINT_CELLS_FILL_H
#define PEL_PAINT_CELLS_FILL_H

#include "cells.h"

/* Draws runs of a cell. */
static PEL_ALWAYS_INLINE void pel_cells_paint(const struct pel_spans *cell,
                                              uint32_t value,
                                              pel_cell_draw draw)
{
#if PEL_SHORT_STACK
    const struct pel_format *const format = cell->surface->format;
    pel_fill_value(cell, value, draw ? format->fill : format->blend);
#else
    pel_fill_value(cell, value, draw);
#endif
}

/* Draws what is left of every row up to hi, from the cell at c->index on. A
 * single row may end earlier: after some cells, in case they are narrow, the
 * next one is looked up. */
static PEL_ALWAYS_INLINE void pel_cells_draw(
    struct pel_cells *c, bool (*end)(struct pel_cells *cells, int32_t count))
{
    bool more = false;
    int32_t left = 64;
    pel_cells_color(c);
    do {
        const uint32_t value = c->value;
        pel_cell_draw draw = c->draw;
        if (PEL_CELL_ROWS > 1) {
#if PEL_SHORT_STACK
            const int32_t count = pel_cells_pass_here(c, PEL_CELLS_PASSED);
            draw = c->present;
#else
            const int32_t count = pel_cells_pass(c, PEL_CELLS_PASSED);
#endif
            more = count ? end(c, count) : pel_cells_end_all(c);
        } else {
            c->at.x0 = c->at.x1;
            do
                (void)(pel_cells_more(c) ? end(c, 1) : pel_cells_end_all(c));
            while (--left && c->at.x1 < c->hi && c->value == value &&
                   c->draw == draw);
        }
        pel_cells_paint(&c->cell, value, draw);
    } while (PEL_CELL_ROWS > 1 ? more : left && c->at.x1 < c->hi);
}

/* Fills spans of narrow cells pixel by pixel: `start` begins a walk along a
 * row, and `colors` takes the next n >= 1 of its colors. */
static PEL_ALWAYS_INLINE void pel_cells_put(
    const struct pel_spans *spans, void *walk,
    void (*start)(void *walk, int32_t x, int32_t y),
    void (*colors)(void *walk, int32_t n, pel_color *out))
{
    enum { COLORS = PEL_AT_A_TIME(PEL_BUFFER_PIXELS, 4) };
    pel_color out[COLORS];
    const struct pel_span *span = spans->span;
    int32_t y = spans->y;
    for (; span < spans->span + spans->n; span++, y += spans->step) {
        int32_t x = span->x0;
        if (x < span->x1)
            start(walk, x, y);
        for (int32_t n; x < span->x1; x += n) {
            n = pel_min(span->x1 - x, COLORS);
            colors(walk, n, out);
            pel_put_colors(spans->surface, x, y, n, out);
        }
    }
}

/* Before pel_cells_fill. `most` rows are filled at a time, whose runs have
 * their memory at `run` where stack is short (NULL: of one row); 0: one row,
 * and every pixel looks for its cell, as cells are narrow. */
static PEL_ALWAYS_INLINE void pel_cells_begin(struct pel_cells *c,
                                              const struct pel_paint *paint,
                                              const struct pel_spans *spans,
                                              int32_t most,
                                              struct pel_span *run)
{
    if (PEL_CELL_ROWS > 1) {
        pel_cells_open(c, (const void *)paint, spans, most);
        c->cell.span = !PEL_SHORT_STACK ? pel_cells_run(c) : run ? run : &c->at;
    } else {
        c->gradient = (const void *)paint;
        c->cell = (struct pel_spans){spans->surface, pel_cells_run(c), spans->y,
                                     1, spans->step};
    }
}

/* Fills spans. `start` finds the cell of the first pixel, its index and the
 * direction, and may bring hi nearer; `end` lets the present cell end where
 * `count` >= 1 cells end, it included, by pel_cells_end: true when pixels are
 * left. Written out where it is called, to spare the stack. */
static PEL_ALWAYS_INLINE void pel_cells_fill(
    struct pel_cells *c, const struct pel_spans *spans,
    void (*start)(struct pel_cells *cells),
    bool (*end)(struct pel_cells *cells, int32_t count))
{
    if (PEL_CELL_ROWS > 1) {
        while (pel_cells_next(c)) {
            start(c);
            pel_cells_draw(c, end);
            c->at.x1 = c->hi;
        }
        return;
    }
    const struct pel_span *span = spans->span;
    const struct pel_span *const last = span + spans->n;
    for (; span < last; c->cell.y += c->cell.step, span++)
        for (c->at.x1 = span->x0; c->at.x1 < span->x1;) {
            c->hi = span->x1;
            start(c);
            pel_cells_draw(c, end);
        }
}

/* Calls `fill`, which fills spans by pel_cells_fill, with memory for the runs
 * of their rows. */
typedef void pel_cells_filler(const struct pel_paint *paint,
                              const struct pel_spans *spans, int32_t most,
                              struct pel_span *run);

/* Where stack is short: with memory for PEL_ROWS runs, for PEL_CELL_ROWS, and
 * for as many as there are rows; one row needs none. */
void pel_cells_fill_few(const struct pel_paint *paint,
                        const struct pel_spans *spans, int32_t most,
                        pel_cells_filler *fill);
void pel_cells_fill_many(const struct pel_paint *paint,
                         const struct pel_spans *spans, int32_t most,
                         pel_cells_filler *fill);

static inline void pel_cells_fill_apart(const struct pel_paint *paint,
                                        const struct pel_spans *spans,
                                        int32_t most, pel_cells_filler *fill)
{
    if (spans->n == 1)
        fill(paint, spans, most, NULL);
    else if (spans->n > PEL_ROWS)
        pel_cells_fill_many(paint, spans, most, fill);
    else
        pel_cells_fill_few(paint, spans, most, fill);
}

#endif
