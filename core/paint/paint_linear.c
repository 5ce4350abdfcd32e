#include "paint_linear.h"

#include "cells_fill.h"
#include "linear_cells.h"

/* Cells of a pixel, from which on to find those of pixels takes less time than
 * to walk over all. */
enum { NARROW = PEL_CELL_ROWS / 4 };
enum { WIDEST = PEL_VECTORS ? 3 : 7 }; /* px: only narrower cells are walked */

static PEL_HOT bool end_cells(struct pel_cells *c, int32_t count)
{
    const struct pel_linear *p = (const void *)c->gradient;
    if (PEL_CELL_ROWS == 1) {
        int64_t error = c->error - p->square;
        for (; error < 0 && c->at.x1 < c->hi; c->at.x1++)
            error += p->step;
        c->error = error;
        return c->at.x1 < c->hi;
    }
    next_cells(c, p, count);
    return pel_cells_end(c, p->d.x, p->d.y, 0);
}

/* From the row where the first pixel's product is lowest to the first. */
static PEL_ALWAYS_INLINE void start(struct pel_cells *c)
{
    const struct pel_linear *p = (const void *)c->gradient;
    const int32_t last =
        PEL_CELL_ROWS > 1 && p->d.y < 0 ? (c->cell.n - 1) * c->cell.step : 0;
    (PEL_SHORT_STACK ? set_cell_here : set_cell)(
        c, p, product_at(p, c->at.x1, c->cell.y + last, p->base.ramp.spread));
    if (PEL_CELL_ROWS > 1)
        c->error -= pel_product(p->d.y, last);
}

/* A row of a vertical gradient has one color. */
static PEL_NOINLINE_32 pel_color level_color(const struct pel_linear *p,
                                             int32_t y)
{
    pel_cell_error error = product_at(p, 0, y, p->base.ramp.spread);
    const int32_t k = find_cell(p, &error);
    return p->base.color(&p->base, index_of(p, p->base.ramp.spread, k));
}

static PEL_STEP_OR_INLINE void fill_level_rows(const struct pel_linear *p,
                                               const struct pel_spans *spans)
{
    struct pel_spans row = *spans;
    for (row.n = 1; row.span < spans->span + spans->n; row.span++) {
        pel_fill_color(&row, level_color(p, row.y));
        row.y += row.step;
    }
}

/* Neighbouring rows of one pixel value are drawn together: at most 8 cells a
 * row are in sight. */
static PEL_STEP_OR_INLINE void fill_level_cells(const struct pel_linear *p,
                                                const struct pel_spans *spans)
{
    const int32_t growth = spans->step ? p->d.y : 0;
    struct pel_cells c;
    struct pel_spans *const rows = &c.cell;
    pel_cells_open(&c, &p->base, spans, PEL_CELL_ROWS);
    rows->span = spans->span;
    set_cell(&c, p, product_at(p, 0, rows->y, p->base.ramp.spread));
    pel_cells_color(&c);
    for (int32_t left = spans->n; left > 0; left -= rows->n) {
        const uint32_t value = c.value;
        const pel_cell_draw draw = c.draw;
        const int32_t count = pel_cells_pass(&c, 8 * left);
        rows->n = left;
        if (count > 0) {
            next_cells(&c, p, count);
            for (rows->n = 0; c.error < 0 && rows->n < left; rows->n++)
                c.error += growth;
        }
        if (rows->n > 0)
            pel_cells_paint(rows, value, draw);
        rows->span += rows->n;
        rows->y += rows->n * rows->step;
    }
}

static void level_fill(const struct pel_paint *paint,
                       const struct pel_spans *spans)
{
    const struct pel_linear *p = (const void *)paint;
    if (spans->n == 1 || p->d.y > 8 * p->cell) /* to walk them takes longer */
        fill_level_rows(p, spans);
    else
        fill_level_cells(p, spans);
}

/* A walk along a row from pixel to pixel, over many cells: the index, and the
 * error where its cell begins. `outside` is below 0 before a padded gradient,
 * and |d|^2 or more behind it. */
struct pixel {
    pel_cell_error outside, error;
    int32_t index;
};

struct row_walk {
    const struct pel_linear *paint;
    struct pixel at;
    pel_cell_error error_step;
    int32_t index_step; /* by less than the period */
};

/* at.outside holds a number of its own here: set_outside sets it later. */
static inline void set_step(struct row_walk *w)
{
    const struct pel_linear *p = w->paint;
    w->error_step = p->step;
    w->at.outside = pel_divide_64(&w->error_step, p->square);
    (void)pel_divide_64(&w->at.outside, p->base.period);
    w->index_step = (int32_t)w->at.outside * p->direction;
}

static PEL_STEP_OR_INLINE void set_outside(struct row_walk *w, int32_t x,
                                           int32_t y)
{
    const struct pel_linear *p = w->paint;
    const int64_t product = along(p, pel_pixel_center(x), pel_pixel_center(y));
    w->at.outside = is_padded(p) ? product + (p->direction >> 31) : 0;
}

static PEL_NOINLINE_32 void row_walk_start(void *walk, int32_t x, int32_t y)
{
    struct row_walk *w = walk;
    set_outside(w, x, y);
    w->at.error = product_at(w->paint, x, y, PEL_REPEAT);
    w->at.index =
        index_of(w->paint, PEL_REPEAT, find_cell(w->paint, &w->at.error));
}

static PEL_NOINLINE_32 void row_walk_colors(void *walk, int32_t n,
                                            pel_color *out)
{
    struct row_walk *w = walk;
    const struct pel_linear *p = w->paint;
    const struct pel_gradient *const g = &p->base;
    const int64_t square = p->square;
    const bool padded = is_padded(p);
    const int64_t outside_step = padded ? 256 * (int64_t)p->d.x : 0;
    struct pixel copy = w->at, *const at = PEL_SHORT_STACK ? &w->at : &copy;
    for (; n > 0; n--, out++) {
        int32_t index = at->index;
        if ((uint64_t)at->outside >= (uint64_t)square)
            index = (at->outside < 0) == (p->direction > 0) ? 0 : g->cells - 1;
        *out = g->color(g, index);
        if (PEL_SHORT_STACK || padded)
            at->outside += outside_step;
        at->error += w->error_step;
        at->index += w->index_step;
        if (at->error >= square) {
            at->error -= square;
            at->index += p->direction;
        }
        if ((uint32_t)at->index >= (uint32_t)g->period)
            at->index += at->index < 0 ? g->period : -g->period;
    }
    if (!PEL_SHORT_STACK)
        w->at = copy;
}

static PEL_NOINLINE_32 void fill_pixels(const struct pel_linear *p,
                                        const struct pel_spans *spans)
{
    struct row_walk w;
    w.paint = p;
    set_step(&w);
    pel_cells_put(spans, &w, row_walk_start, row_walk_colors);
}

static PEL_STEP_OR_INLINE void fill_rows(const struct pel_paint *paint,
                                         const struct pel_spans *spans,
                                         int32_t most, struct pel_span *run)
{
    const struct pel_linear *p = (const void *)paint;
    struct pel_cells c;
    pel_cells_begin(&c, paint, spans, most, run);
    if (PEL_SHORT_STACK) /* else set_cell does */
        c.direction = (pel_cell_direction)p->direction;
    pel_cells_fill(&c, spans, start, end_cells);
}

/* Rows are drawn one by one where boundaries lie far apart from row to row, and
 * rows cross many of them. 0: cells are narrow. */
static PEL_STEP_OR_INLINE int32_t rows_at_a_time(const struct pel_linear *p,
                                                 const struct pel_spans *spans)
{
    const int64_t down = pel_size_of(p->d.y);
    if (PEL_CELL_ROWS > 1 && p->step >= NARROW * p->square &&
        pel_cells_are_many(&p->base, spans))
        return 0;
    return down > 32 * p->d.x && down > p->cell ? 1 : PEL_CELL_ROWS;
}

/* Opaque, and of cells that are 1/2 to WIDEST px wide: vectors are faster with
 * others. */
static PEL_STEP_OR_INLINE bool can_walk(const struct pel_linear *p,
                                        const struct pel_channels *c)
{
    const pel_color *const colors = p->base.ramp.colors;
    return c && c->walk && p->base.ramp.n == 2 &&
           pel_alpha(colors[0] & colors[1]) == 255 &&
           p->cell < pel_product(WIDEST, p->d.x) && p->d.x < 2 * p->cell;
}

/* Fills the rows of a dither, which shows every cell, from the row where
 * products are least on. False, and nothing is done, unless it can be walked,
 * and the hull is all on one run from the first cell to the last: then errors
 * are below 256 WIDEST d.x < 2^30. */
static PEL_NOINLINE_32 bool fill_walked(const struct pel_linear *p,
                                        const struct pel_spans *spans)
{
    const struct pel_channels *const channels =
        spans->surface->format->channels;
    const int64_t growth = spans->step ? pel_size_of(p->d.y) : 0;
    const bool up = p->d.y < 0;
    const int32_t last = spans->n - 1;
    struct pel_span hull;
    struct pel_cells c;
    if (!pel_spans_hull(&hull, spans->span, spans->n))
        return false;
    const int64_t least = product_at(
        p, hull.x0, spans->y + up * last * spans->step, p->base.ramp.spread);
    const int64_t across = pel_product(p->d.x, hull.x1 - 1 - hull.x0);
    if (least <= 0 || least + 256 * (across + growth * last) >= p->square)
        return false;
    struct pel_walk walk = {.cell = (int32_t)p->cell,
                            .cell_remainder = p->cell_remainder,
                            .unit = unit_of(p),
                            .step = p->d.x};
    c.gradient = &p->base;
    set_cell(&c, p, least);
    next_cells(&c, p, 1);
    for (int32_t i = 0; i <= last; i++, c.error += growth) {
        for (; c.error >= 0; next_cells(&c, p, 1))
            pel_cells_go(&c);
        const int32_t k = up ? last - i : i;
        const struct pel_span run = spans->span[k];
        if (run.x0 >= run.x1)
            continue;
        pel_mix_start(&walk.mix, &p->base, c.index, p->direction);
        walk.error = (int32_t)c.error + p->d.x * (run.x0 - hull.x0);
        walk.remainder = c.whole;
        if (!channels->walk(spans->surface, run.x0, spans->y + k * spans->step,
                            run.x1 - run.x0, &walk))
            return false;
    }
    return true;
}

static void fill_anew(const struct pel_paint *paint,
                      const struct pel_spans *spans)
{
    const struct pel_linear *p = (const void *)paint;
    if (PEL_CELL_ROWS > 1 && can_walk(p, spans->surface->format->channels) &&
        fill_walked(p, spans))
        return;
    const int32_t rows =
        PEL_CELL_ROWS == 1 ? PEL_CELL_ROWS : rows_at_a_time(p, spans);
    if (rows == 0 && spans->surface->format->put)
        fill_pixels(p, spans);
    else if (PEL_SHORT_STACK)
        pel_cells_fill_apart(paint, spans, rows, fill_rows);
    else
        fill_rows(paint, spans, rows, NULL);
}

/* Rows of a horizontal gradient are copied, but not where stack is short. */
static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    const struct pel_linear *p = (const void *)paint;
    if (PEL_SHORT_STACK || PEL_CELL_ROWS == 1 || p->d.y ||
        !pel_cells_copy(&p->base, spans, fill_anew))
        fill_anew(paint, spans);
}

enum pel_status pel_linear_init(struct pel_linear *paint, struct pel_point from,
                                struct pel_point to,
                                const struct pel_ramp *ramp)
{
    const enum pel_status status = pel_gradient_init((void *)paint, ramp);
    if (status != PEL_OK)
        return status;
    if (!pel_point_legal(from) || !pel_point_legal(to))
        return PEL_ERROR_RANGE;
    struct pel_point d = {to.x - from.x, to.y - from.y};
    if ((d.x | d.y) == 0)
        return PEL_ERROR_SIZE;
    paint->base.paint.fill = PEL_CELL_ROWS == 1 || d.x ? fill : level_fill;
    const int32_t onward = d.x || PEL_CELL_ROWS == 1 ? d.x : d.y;
    paint->direction = (onward > 0) - (onward < 0);
    if (paint->direction < 0) {
        from = to;
        d = (struct pel_point){-d.x, -d.y};
    }
    paint->from = from;
    paint->d = d;
    paint->square = along(paint, from.x + d.x, from.y + d.y);
    paint->step = pel_product(unit_of(paint), d.x);
    if (PEL_CELL_ROWS > 1) {
        int64_t remainder = paint->square;
        paint->cell = pel_divide_64(&remainder, unit_of(paint));
        paint->cell_remainder = (int32_t)remainder;
    }
    return PEL_OK;
}
