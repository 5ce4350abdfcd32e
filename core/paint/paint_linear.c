#include "paint_linear.h"

#include "../base/divide.h"
#include "cells.h"

/* (P - from).d at pixel (x, y). Below 2^50. */
static int64_t product_at(const struct pel_linear *p, int32_t x, int32_t y)
{
    return pel_product(pel_pixel_center(x) - p->from.x, p->d.x) +
           pel_product(pel_pixel_center(y) - p->from.y, p->d.y);
}

/* A pixel lies beyond the end of cell k when n product - (k + 1) square, which
 * is walked in whole units of 256 n, is 0 or more. Where products fall to the
 * right, so do cells, and it is k square - 1 - n product. */
struct lines {
    struct pel_cells cells;
    uint32_t part; /* what is left of the error, in units */
};

static uint32_t unit_of(const struct pel_linear *p)
{
    return (uint32_t)p->base.cells << 8;
}

/* To the end of the next cell. */
static void next_line(struct lines *l, const struct pel_linear *p)
{
    l->cells.end.error -= p->cell;
    if (l->part < p->cell_rest) {
        l->part += unit_of(p);
        l->cells.end.error--;
    }
    l->part -= p->cell_rest;
}

static PEL_CELL_STEP bool end_cells(struct pel_cells *cells, int32_t count)
{
    const struct pel_linear *p = (const void *)cells->gradient;
    struct lines *l = (void *)cells;
    while (--count)
        next_line(l, p);
    const bool rest = pel_cells_end(cells);
    next_line(l, p);
    return rest;
}

/* The cell of a pixel with this product, and how far it is from its end. Before
 * a padded way the first cell ends where the second begins: `beyond` is the
 * product from there or, where cells fall, from `to` on. Of an error < 0, all
 * bits turned round are divided and turned back. n gone < 2^15 2^49. */
static PEL_NOINLINE_32 void set_cell(struct lines *l,
                                     const struct pel_linear *p,
                                     int64_t product)
{
    const uint64_t square = (uint64_t)p->square;
    const bool falling = p->d.x < 0;
    uint64_t gone, rest, beyond = 0;
    int32_t copy = (int32_t)pel_divide_64(
        (uint64_t)(product < 0 ? ~product : product), square, &gone);
    if (product < 0) {
        copy = ~copy;
        gone = square - 1 - gone;
    }
    int32_t part =
        (int32_t)pel_divide_64(pel_times(gone, p->base.cells), square, &rest);
    l->cells.place = pel_gradient_place(&p->base, copy, part);
    if (p->base.period == 0 && (falling ? copy > 0 : copy < 0)) {
        beyond = (uint64_t)(falling ? product - p->square : -product);
        rest = falling ? square : 0;
    }
    rest = (falling ? rest : square - 1 - rest) +
           pel_times(beyond & 255, p->base.cells);
    l->cells.end.error =
        ~(int64_t)(pel_divide_64(rest, unit_of(p), &rest) + (beyond >> 8));
    l->part = unit_of(p) - 1 - (uint32_t)rest;
}

/* At the first pixel of the first row, in the lowest cell of any row. */
static PEL_NOINLINE_32 void start(struct lines *l, const struct pel_linear *p)
{
    struct pel_cells *c = &l->cells;
    const bool falling = p->d.x < 0;
    const int32_t row = falling ? -p->d.y : p->d.y;
    const int32_t last = row < 0 ? (c->cell.n - 1) * c->cell.step : 0;
    c->way = falling ? -1 : 1;
    set_cell(l, p, product_at(p, c->lo, c->cell.y + last));
    c->end.error -= pel_product(row, last);
    c->end.x = c->lo;
    c->end.step = falling ? -p->d.x : p->d.x;
    c->end.bend = 0;
    c->end.row = row;
    c->end.row_bend = 0;
    if (p->d.x == 0)
        c->limit = 0;
}

/* A function of its own, to spare the stack of what comes before it. */
static PEL_NOINLINE_32 void walk(struct lines *l)
{
    pel_cells_draw(&l->cells, end_cells);
}

/* Where boundaries lie far apart from row to row, the rows are drawn one by
 * one, and where cells are narrower than 1/16 px, so are pixels. */
static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    const struct pel_linear *p = (const void *)paint;
    const int32_t dx = p->d.x < 0 ? -p->d.x : p->d.x;
    const int32_t dy = p->d.y < 0 ? -p->d.y : p->d.y;
    const bool by_pixel = p->base.period && (dx + dy) >> 4 > p->cell;
    struct lines l;
    pel_cells_open(&l.cells, &p->base, spans);
    while (pel_cells_next(&l.cells, spans,
                          by_pixel || dy > 8 * dx ? 1 : PEL_CELL_ROWS)) {
        if (by_pixel)
            l.cells.hi = l.cells.lo + 1;
        start(&l, p);
        walk(&l);
    }
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
    paint->from = from;
    paint->d = (struct pel_point){to.x - from.x, to.y - from.y};
    paint->square = pel_square(paint->d.x) + pel_square(paint->d.y);
    uint64_t rest;
    paint->cell =
        (int64_t)pel_divide_64((uint64_t)paint->square, unit_of(paint), &rest);
    paint->cell_rest = (uint32_t)rest;
    return PEL_OK;
}
