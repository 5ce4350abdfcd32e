#include "paint_linear.h"

#include "../base/divide.h"
#include "cells.h"

enum { FAR = 1 << 18 }; /* px: beyond every pixel, seen from any other */

/* A pixel on the way: in cell `part` of copy number `copy` of the way, of whose
 * beginning its product is `rest` beyond, 0 <= rest < square. */
struct position {
    int32_t copy, part;
    int64_t rest;
};

/* (P - from).d at pixel (x, y). Below 2^50. */
static int64_t product_at(const struct pel_linear *p, int32_t x, int32_t y)
{
    return pel_product(pel_pixel_center(x) - p->from.x, p->d.x) +
           pel_product(pel_pixel_center(y) - p->from.y, p->d.y);
}

/* n rest < 2^15 2^49. Seen from `to`, who is on a boundary is still before it:
 * it belongs to the cell that begins there for who comes from `from`. */
static PEL_NOINLINE_32 struct position position_of(const struct pel_linear *p,
                                                   int64_t product)
{
    const uint64_t square = (uint64_t)p->square;
    struct pel_fraction f;
    uint64_t rest;
    pel_fraction_start(&f, product, p->square);
    struct position at = {(int32_t)f.quotient, 0, f.rest};
    at.part = (int32_t)pel_divide_64(pel_times((uint64_t)f.rest, p->base.cells),
                                     square, &rest);
    if (p->reversed && rest == 0 && at.part-- == 0) {
        at.part += p->base.cells;
        at.rest += p->square;
        at.copy--;
    }
    return at;
}

static int32_t place_of(const struct pel_linear *p, const struct position *at)
{
    const int32_t place = pel_gradient_place(&p->base, at->copy, at->part);
    if (!p->reversed)
        return place;
    const int32_t mirrored = p->base.cells - 1 - place;
    return mirrored < 0 ? mirrored + p->base.period : mirrored;
}

/* The boundaries of a linear gradient are parallel lines. A pixel lies beyond
 * number k when its product is at least k square / n, rounded up (and from `to`
 * when it is more). In the first row that is the pixel floor(f / (256 d.x)),
 * with an f that grows by square / n from one boundary to the next. */
struct lines {
    struct pel_cells cells;
    int32_t x;     /* where the present cell ends: of f the quotient, */
    uint32_t m;    /* what is left, below 256 d.x, */
    uint32_t part; /* and of the rounding what is left, in 1/n */
};

/* m grows by `by` <= width = 256 d.x < 2^32. */
static inline void line_add(int32_t *x, uint32_t *m, uint32_t width,
                            uint32_t by)
{
    if (*m >= width - by) {
        *m -= width;
        ++*x;
    }
    *m += by;
}

/* To the end of `count` cells more. */
static void next_lines(struct lines *l, const struct pel_linear *p,
                       int32_t count)
{
    const uint32_t width = (uint32_t)p->d.x << 8, n = (uint32_t)p->base.cells;
    const uint32_t cell_rest = p->cell_rest, part_rest = p->part_rest;
    const int32_t cell = p->cell;
    uint32_t m = l->m, part = l->part;
    int32_t x = l->x;
    for (; count > 0 && x < 2 * FAR; count--) {
        x += cell;
        line_add(&x, &m, width, cell_rest);
        part += part_rest;
        if (part >= n) {
            part -= n;
            line_add(&x, &m, width, 1);
        }
    }
    l->x = x;
    l->m = m;
    l->part = part;
}

/* An edge does without the lowest 8 bits, which never change from row to row.
 */
static void end_cells(struct pel_cells *cells, int32_t count)
{
    const struct pel_linear *p = (const void *)cells->gradient;
    struct lines *l = (void *)cells;
    next_lines(l, p, count - 1);
    struct pel_edge edge = {l->x, (int32_t)(l->m >> 8) - p->d.x, p->down,
                            p->down_rest, p->d.x};
    pel_cells_end_at(cells, &edge);
    next_lines(l, p, 1);
}

/* The boundary after a position, where it crosses the row of the position's
 * pixel, x; at product. Before a padded way the first cell ends where the
 * second begins. */
static PEL_NOINLINE_32 void set_end(struct lines *l, const struct pel_linear *p,
                                    const struct position *at, int64_t product)
{
    const bool before = p->base.period == 0 && at->copy < 0;
    const int32_t n = p->base.cells;
    const int64_t width = (int64_t)p->d.x * 256;
    struct pel_fraction f;
    uint64_t part;
    const uint64_t line = pel_divide_64(
        pel_times((uint64_t)p->square, before ? 1 : at->part + 1) +
            (uint64_t)(n - 1 + p->reversed),
        (uint64_t)n, &part);
    pel_fraction_start(
        &f, (int64_t)line - (before ? product : at->rest) + width - 1, width);
    l->x += f.quotient > FAR ? FAR : (int32_t)f.quotient;
    l->m = (uint32_t)f.rest;
    l->part = (uint32_t)part;
}

/* In the cell of the first pixel on the way, or before it. */
static PEL_NOINLINE_32 bool lines_start(struct lines *l,
                                        const struct pel_linear *p,
                                        const struct pel_spans *spans)
{
    if (!pel_cells_begin(&l->cells, &p->base, spans))
        return false;
    int32_t row = p->d.y < 0 ? (spans->n - 1) * spans->step : 0;
    const int64_t product = product_at(p, l->cells.all.x0, spans->y + row);
    const struct position at = position_of(p, product);
    l->cells.step = p->reversed ? -1 : 1;
    l->cells.place = place_of(p, &at);
    l->x = l->cells.all.x0;
    if (p->d.x == 0)
        l->cells.limit = 0;
    else
        set_end(l, p, &at, product);
    for (; row > 0; row--) {
        l->x -= p->down + 1;
        if (p->d.x)
            line_add(&l->x, &l->m, (uint32_t)p->d.x << 8,
                     (uint32_t)(p->d.x - p->down_rest) << 8);
    }
    return true;
}

/* A function of its own, to spare the stack of what comes before it. */
static PEL_NOINLINE_32 void walk(struct lines *l)
{
    pel_cells_draw(&l->cells, end_cells);
}

/* Rows of which the boundaries lie at most 129 pixels apart. */
static void draw(const struct pel_gradient *gradient,
                 const struct pel_spans *spans)
{
    struct lines l;
    if (lines_start(&l, (const void *)gradient, spans))
        walk(&l);
}

/* Where boundaries lie far apart from row to row the rows are drawn one by one.
 */
static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    const struct pel_linear *p = (const void *)paint;
    const bool steep = p->d.x == 0 || p->down > 128 || p->down < -128;
    if (p->by_pixel || steep)
        pel_gradient_parts(&p->base, spans, p->by_pixel ? 1 : FAR, draw);
    else
        draw(&p->base, spans);
}

static void set_steps(struct pel_linear *p)
{
    const int32_t n = p->base.cells, dy = p->d.y < 0 ? -p->d.y : p->d.y;
    struct pel_fraction f;
    p->square = pel_square(p->d.x) + pel_square(p->d.y);
    p->by_pixel =
        p->base.period && pel_long_product(p->d.x + dy, n * 16) > p->square;
    if (p->d.x == 0)
        return;
    pel_fraction_start(&f, p->square, n);
    p->part_rest = (uint32_t)f.rest;
    pel_fraction_start(&f, (int64_t)f.quotient, (int64_t)p->d.x * 256);
    p->cell = f.quotient > FAR ? FAR : (int32_t)f.quotient;
    p->cell_rest = (uint32_t)f.rest;
    p->down = pel_floor_divide(-p->d.y, p->d.x, &p->down_rest);
}

enum pel_status pel_linear_init(struct pel_linear *paint, struct pel_point from,
                                struct pel_point to,
                                const struct pel_ramp *ramp)
{
    if (!paint)
        return PEL_ERROR_NULL;
    const enum pel_status status = pel_gradient_init(&paint->base, ramp);
    if (status != PEL_OK)
        return status;
    if (!pel_point_legal(from) || !pel_point_legal(to))
        return PEL_ERROR_RANGE;
    if (from.x == to.x && from.y == to.y)
        return PEL_ERROR_SIZE;
    paint->base.paint = (struct pel_paint){fill, NULL};
    paint->reversed = to.x < from.x;
    paint->from = paint->reversed ? to : from;
    const struct pel_point end = paint->reversed ? from : to;
    paint->d = (struct pel_point){end.x - paint->from.x, end.y - paint->from.y};
    set_steps(paint);
    return PEL_OK;
}
