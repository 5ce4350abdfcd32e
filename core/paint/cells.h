/* The walk of rows through the cells of a gradient (gradient.h).
 *
 * A batch of rows is drawn a cell at a time, from left to right. A pixel lies
 * beyond the boundary where a cell ends when its error is 0 or more; the error
 * is a polynomial of x and y, so it is walked by additions: from pixel to
 * pixel, and from row to row, where the boundary has moved by a few pixels.
 * What lies before it in every row is one call to the format, with one color.
 * Neighbours that are the same pixel value are one cell. Functions without a
 * body here are in gradient.c. */
#ifndef PEL_PAINT_CELLS_H
#define PEL_PAINT_CELLS_H

#include "../base/divide.h"
#include "../format/word.h"
#include "gradient.h"

/* Rows of a batch: one where code is to be small, and at most 32, for which
 * errors of 32 bits do in all rows but the first; 31 where stack is short,
 * which five bits hold. */
enum { PEL_CELL_ROWS_MOST = PEL_AT_A_TIME(32, 31) };
enum {
    PEL_CELL_ROWS = PEL_SMALL_CODE                        ? 1
                    : PEL_BATCH_ROWS < PEL_CELL_ROWS_MOST ? PEL_BATCH_ROWS
                                                          : PEL_CELL_ROWS_MOST
};

/* Where stack is short members are, too, and more so where registers are few.
 * How a cell is drawn: by the format's fill when it is opaque, else by its
 * blend. */
#if PEL_SHORT_STACK
typedef uint16_t pel_cell_index;
typedef int8_t pel_cell_direction;
typedef bool pel_cell_draw;
#define PEL_CELL_BIT : 1
#else
typedef int32_t pel_cell_index, pel_cell_direction;
typedef void (*pel_cell_draw)(const struct pel_spans *spans, uint32_t value);
#define PEL_CELL_BIT
#endif
#if PEL_SHORT_STACK && PEL_FEW_REGISTERS
typedef unsigned pel_cell_most;
typedef uint16_t pel_cell_rest;
#define PEL_CELL_BITS(n) : n
#else
typedef uint8_t pel_cell_most;
typedef int32_t pel_cell_rest;
#define PEL_CELL_BITS(n)
#endif
typedef pel_dividend pel_cell_error;

/* A batch of rows among the cells. A cell's index is its number
 * from 0 on, and below the period. */
struct pel_cells {
    pel_cell_error error; /* of the boundary where the present cell ends, */
    struct pel_span at;   /* at pixel at.x1 of the first row; of one row the run
                             itself, where stack is short or code small */
    int32_t hi;           /* runs end here at the farthest */

#if !PEL_SMALL_CODE
    const struct pel_span *span; /* the shape's, of these rows */
    bool box PEL_CELL_BIT;       /* they are all alike */
    bool mixed PEL_CELL_BIT;     /* opaque, of two: pel_cells_pass_mixed */
    pel_cell_draw present PEL_CELL_BITS(1); /* how the present one is drawn */
    pel_cell_most most PEL_CELL_BITS(5); /* rows of a batch; 0: one, and hi is
                                            the next pixel */
    uint8_t left;                        /* spans from `span` on */
#endif

    /* The next cell: its index, the direction to the one behind it (1 or -1; 0:
     * none comes), how it is drawn. */
    pel_cell_index index;
    pel_cell_direction direction;
    pel_cell_draw draw;

    /* Where the present cell begins, rounded down, and what that drops: a
     * radius of a radial gradient, an angle of a conic one. Of a linear one
     * `whole` is what units leave of the error. */
    pel_cell_rest remainder;
    int32_t whole;

    uint32_t value; /* of the next cell: a pixel, or a color not opaque */
    const struct pel_gradient *gradient;
    struct pel_spans cell; /* the present cell's runs: pel_cells_run */

#if !PEL_SHORT_STACK && !PEL_SMALL_CODE
    int32_t end;    /* px: where all of them have ended */
    pel_color mask; /* of mixed colors what can be seen; 0: ask the format */
    struct pel_span run[PEL_CELL_ROWS];
#endif
};

/* The run of the present cell in every row. Where stack is short the memory of
 * more than one lies apart: few rows take less of it. */
static inline struct pel_span *pel_cells_run(struct pel_cells *c)
{
#if PEL_SMALL_CODE
    return &c->at;
#elif PEL_SHORT_STACK
    return (struct pel_span *)(uintptr_t)c->cell.span;
#else
    return c->run;
#endif
}

/* The index of the cell `part` of copy number `copy` of the ramp; of a padded
 * one copy >= 0. */
static inline int32_t pel_cells_index(const struct pel_gradient *g,
                                      int32_t copy, int32_t part)
{
    if (g->ramp.spread == PEL_PAD)
        return copy > 0 ? g->cells - 1 : part;
    return part + (copy & 1) * (g->period - g->cells);
}

/* The middle of cell i of 256 from a to b, rounded: a + (b - a) (2 i + 1) /
 * 512, for two channels in the halves of a word, is the upper byte of a sum
 * that changes by b - a from cell to cell. In each half it is between 128 and
 * 255 * 256 + 128, so nothing is left over between them, though b - a may be
 * negative. */
static inline uint32_t pel_mix_sum(uint32_t a, uint32_t change, int32_t i)
{
    const uint32_t half = (change + UINT32_C(0x01000100)) >> 1;
    return a * 256 + (half & UINT32_C(0x00FF00FF)) + change * (uint32_t)i;
}

/* From cell i on, up where direction is 1, or down: -1. */
static PEL_HOT void pel_mix_start(struct pel_mix *mix,
                                  const struct pel_gradient *g, int32_t i,
                                  int32_t direction)
{
    const pel_color a = g->ramp.colors[0], b = g->ramp.colors[1];
    const uint32_t m = 0xFF00FFu, high = (b >> 8 & m) - (a >> 8 & m);
    const uint32_t low = (b & m) - (a & m), sign = (uint32_t)direction;
    mix->high = pel_mix_sum(a >> 8 & m, high, i);
    mix->low = pel_mix_sum(a & m, low, i);
    mix->high_change = sign * high;
    mix->low_change = sign * low;
}

static inline pel_color pel_mixed(struct pel_mix mix)
{
    return (mix.high & UINT32_C(0xFF00FF00)) | (mix.low >> 8 & 0xFF00FFu);
}

/* Goes on to the next cell's index; false where none comes, or none but the
 * present one. */
static PEL_ALWAYS_INLINE bool pel_cells_go(struct pel_cells *c)
{
    const struct pel_gradient *g = c->gradient;
    int32_t next = c->index + c->direction;
    if ((uint32_t)next >= (uint32_t)g->period)
        next = g->ramp.spread == PEL_PAD ? c->index
                                         : next - c->direction * g->period;
    if (next == c->index)
        return false;
    c->index = (pel_cell_index)next;
    return true;
}

/* Before the first batch, and before cell.span is set. */
void pel_cells_open(struct pel_cells *cells,
                    const struct pel_gradient *gradient,
                    const struct pel_spans *spans, int32_t most);

/* How many pixels n spans have, and where: from the left end of all to the
 * right end. Of none x0 > x1. */
int32_t pel_spans_hull(struct pel_span *hull, const struct pel_span *span,
                       int32_t n);

/* Sets the rows, x, hi and where runs begin. While x, which the caller has
 * moved to hi, is not the end of the batch, that goes on there; else the next
 * one begins, of at most cells->most rows. Where that is 0 it has one row, and
 * hi is the next pixel. False when no pixel is left. */
bool pel_cells_next(struct pel_cells *cells);

/* Of narrow cells: are there more than a walk should pass? Of a ramp that does
 * not begin anew it passes each once. */
static inline bool pel_cells_are_many(const struct pel_gradient *g,
                                      const struct pel_spans *spans)
{
    struct pel_span hull;
    return g->ramp.spread != PEL_PAD ||
           pel_spans_hull(&hull, spans->span, spans->n) < g->cells;
}

/* All rows of a horizontal gradient are alike, so one is drawn by `fill`, and
 * the others are copied from it. False, and nothing is done: that does not pay,
 * or is wrong (colors are blended, pixels share bytes, or the format is a
 * dither's or the program's own). In cells_copy.c. */
bool pel_cells_copy(const struct pel_gradient *gradient,
                    const struct pel_spans *spans,
                    void (*fill)(const struct pel_paint *paint,
                                 const struct pel_spans *spans));

/* Takes the color of the cell at c->index. */
void pel_cells_color(struct pel_cells *c);

/* Cells of one pixel value are one, up to so many: more may be out of sight. */
enum { PEL_CELLS_PASSED = 2048 };

/* Looks at cells from the one at c->index on until the pixel value changes, or
 * `most` of them or some more have been seen; returns how many have the value,
 * 0: all that may come. Moves on to the next. */
int32_t pel_cells_pass(struct pel_cells *c, int32_t most);

/* Goes on to the next cell and takes its color; false where none comes. */
static PEL_ALWAYS_INLINE bool pel_cells_more(struct pel_cells *c)
{
    const bool more = pel_cells_go(c);
    if (more)
        pel_cells_color(c);
    return more;
}

#if !PEL_SMALL_CODE
/* Goes on to the last of the cells of two mixed colors that look like the one
 * at c->index, but not beyond the end of the ramp. Returns how many it passed.
 * Formats drop the low bits of channels. Not for grey, which shows a sum. */
int32_t pel_cells_pass_mixed(struct pel_cells *c);

/* As pel_cells_pass, in place: where stack is short. */
static PEL_ALWAYS_INLINE int32_t pel_cells_pass_here(struct pel_cells *c,
                                                     int32_t most)
{
    const uint32_t value = c->value;
    const pel_cell_draw draw = c->present = c->draw;
    int32_t count = 0;
    do {
        if (c->mixed)
            count += pel_cells_pass_mixed(c);
        if (count++ >= c->gradient->period || !pel_cells_more(c))
            return 0;
    } while (c->value == value &&
             c->draw == (PEL_SHORT_STACK ? c->present : draw) && count < most);
    return count;
}
#endif

/* Ends all runs at the boundary, whose error is set. It grows by `step` to the
 * next pixel, and by `row` to the one below; `row` from row to row, and the
 * step from pixel to pixel, by `bend`. true when pixels are left. */
bool pel_cells_end(struct pel_cells *c, int32_t step, int32_t row,
                   int32_t bend);

/* Ends all runs at hi: no pixel is left. For that the error is below 0 and
 * never grows; where stack is short a step of PEL_CELL_ALL says so instead, as
 * `at` may be a run that goes on. */
enum { PEL_CELL_ALL = 0x7FFFFFFF };

static inline bool pel_cells_end_all(struct pel_cells *c)
{
    if (PEL_SHORT_STACK)
        return pel_cells_end(c, PEL_CELL_ALL, 0, 0);
    c->at.x1 = c->hi;
    if (PEL_CELL_ROWS == 1)
        return false;
    c->error = -1;
    return pel_cells_end(c, 0, 0, 0);
}

/* Moves by `count` >= 1 cells, each `width` and part / n wide. */
static PEL_ALWAYS_INLINE void pel_cells_move(struct pel_cells *c, int32_t count,
                                             int32_t width, int32_t part,
                                             int32_t n)
{
    const int32_t direction = c->direction;
    int32_t remainder = c->remainder;
    do {
        c->whole += direction * width;
        remainder += direction * part;
        if ((uint32_t)remainder >= (uint32_t)n) {
            remainder -= direction * n;
            c->whole += direction;
        }
    } while (--count);
    c->remainder = (pel_cell_rest)remainder;
}

#endif
