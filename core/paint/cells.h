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

#include "../format/word.h"
#include "gradient.h"

/* Rows of a batch: one where code is to be small, and at most 32: then errors
 * of 32 bits do for all rows but the first. */
enum {
    PEL_CELL_ROWS = PEL_SMALL_CODE        ? 1
                    : PEL_BATCH_ROWS < 32 ? PEL_BATCH_ROWS
                                          : 32
};

/* A batch of rows among the cells. A cell's index is its number
 * from 0 on, and below the period. */
struct pel_cells {
    int64_t error;     /* of the boundary where the present cell ends, */
    int32_t x;         /* at this pixel of the first row */
    int32_t direction; /* to the next cell's index: 1, -1; 0: none comes */
    int32_t hi;        /* runs end here at the farthest */

    /* The next cell: its pixel value and the format's fill, or its color,
     * which is not opaque, and the blend. */
    uint32_t value;
    void (*draw)(const struct pel_spans *spans, uint32_t value);

    const struct pel_gradient *gradient;
    struct pel_spans cell; /* the present cell's runs */

    int32_t index; /* of the next cell */

    /* Of a radial gradient the radius where the present cell begins, of a conic
     * one the angle, rounded down. */
    int32_t whole;
    int32_t remainder; /* of the radius or angle, or of a linear one's error */

#if !PEL_SMALL_CODE
    const struct pel_span *span; /* the shape's, of these rows */
    int32_t end;                 /* px: where all of them have ended */
    uint8_t left;                /* spans from `span` on */
    bool box;                    /* these are all alike */
    pel_color mask; /* of mixed colors what can be seen; 0: ask the format */
#endif

    /* The run of the present cell, in every row. */
    struct pel_span run[PEL_CELL_ROWS];
};

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
static PEL_SHARED void pel_mix_start(struct pel_mix *mix,
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
    c->index = next;
    return true;
}

/* Before the first batch. */
void pel_cells_open(struct pel_cells *cells,
                    const struct pel_gradient *gradient,
                    const struct pel_spans *spans);

/* How many pixels n spans have, and where: from the left end of all to the
 * right end. Of none x0 > x1. */
int32_t pel_spans_hull(struct pel_span *hull, const struct pel_span *span,
                       int32_t n);

/* Sets the rows, x, hi and where runs begin. While x, which the caller has
 * moved to hi, is not the end of the batch, that goes on there; else the next
 * one begins, of at most `most` <= PEL_CELL_ROWS rows. With `most` 0 it has one
 * row, and hi is the next pixel. False when no pixel is left. */
bool pel_cells_next(struct pel_cells *cells, int32_t most);

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

/* Ends all runs at the boundary, whose error is set. It grows by `step` to the
 * next pixel, and by `row` to the one below; `row` from row to row, and the
 * step from pixel to pixel, by `bend`. true when pixels are left. */
bool pel_cells_end(struct pel_cells *c, int32_t step, int32_t row,
                   int32_t bend);

/* Ends all runs at hi: an error below 0 that never grows. No pixel is left. */
static inline bool pel_cells_end_all(struct pel_cells *c)
{
    c->x = c->hi;
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
    do {
        c->whole += direction * width;
        c->remainder += direction * part;
        if ((uint32_t)c->remainder >= (uint32_t)n) {
            c->remainder -= direction * n;
            c->whole += direction;
        }
    } while (--count);
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
        void (*const draw)(const struct pel_spans *, uint32_t) = c->draw;
        if (PEL_CELL_ROWS > 1) {
            const int32_t count = pel_cells_pass(c, PEL_CELLS_PASSED);
            more = count ? end(c, count) : pel_cells_end_all(c);
        } else {
            c->run[0].x0 = c->x;
            do
                (void)(pel_cells_more(c) ? end(c, 1) : pel_cells_end_all(c));
            while (--left && c->x < c->hi && c->value == value &&
                   c->draw == draw);
            c->run[0].x1 = c->x;
        }
        pel_fill_value(&c->cell, value, draw);
    } while (PEL_CELL_ROWS > 1 ? more : left && c->x < c->hi);
}

/* Fills spans of narrow cells pixel by pixel: `start` begins a walk along a
 * row, and `colors` takes the next n >= 1 of its colors. */
static PEL_ALWAYS_INLINE void pel_cells_put(
    const struct pel_spans *spans, void *walk,
    void (*start)(void *walk, int32_t x, int32_t y),
    void (*colors)(void *walk, int32_t n, pel_color *out))
{
    pel_color out[PEL_BUFFER_PIXELS];
    const struct pel_span *span = spans->span;
    int32_t y = spans->y;
    for (int32_t i = spans->n; i > 0; i--, span++, y += spans->step) {
        if (span->x0 < span->x1)
            start(walk, span->x0, y);
        for (int32_t x = span->x0, n; x < span->x1; x += n) {
            n = pel_min(span->x1 - x, PEL_BUFFER_PIXELS);
            colors(walk, n, out);
            pel_put_colors(spans->surface, x, y, n, out);
        }
    }
}

/* Fills spans, `most` rows at a time; 0: one, and every pixel looks for its
 * cell, as cells are narrow. `start` finds the cell of the first pixel, its
 * index and the direction, and may bring hi nearer; `end` lets the present cell
 * end where `count` >= 1 cells end, it included, by pel_cells_end: true when
 * pixels are left. Written out where it is called, to spare the stack. */
static PEL_ALWAYS_INLINE void pel_cells_fill(
    const struct pel_paint *paint, const struct pel_spans *spans, int32_t most,
    void (*start)(struct pel_cells *cells),
    bool (*end)(struct pel_cells *cells, int32_t count))
{
    struct pel_cells c;
    if (PEL_CELL_ROWS > 1) {
        pel_cells_open(&c, (const void *)paint, spans);
        while (pel_cells_next(&c, most)) {
            start(&c);
            pel_cells_draw(&c, end);
            c.x = c.hi;
        }
        return;
    }
    c.gradient = (const void *)paint;
    c.cell =
        (struct pel_spans){spans->surface, c.run, spans->y, 1, spans->step};
    const struct pel_span *span = spans->span;
    const struct pel_span *const last = span + spans->n;
    for (; span < last; c.cell.y += c.cell.step, span++)
        for (c.x = span->x0; c.x < span->x1;) {
            c.hi = span->x1;
            start(&c);
            pel_cells_draw(&c, end);
        }
}

#endif
