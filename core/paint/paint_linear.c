#include "paint_linear.h"

#include "../base/divide.h"
#include "cells.h"

/* (P - from).d at pixel (x, y). Below 2^50. */
static PEL_NOINLINE_32 int64_t product_at(const struct pel_linear *p, int32_t x,
                                          int32_t y)
{
    return pel_product(pel_pixel_center(x) - p->from.x, p->d.x) +
           pel_product(pel_pixel_center(y) - p->from.y, p->d.y);
}

/* The error of the boundary where cell k begins is n product - k square: whole
 * units of 256 n, by which it grows from pixel to pixel, and what they leave
 * (c->rest, from -1 to 256 n - 1). Where products fall to the right, so do
 * cells, and it is (k + 1) square - 1 - n product. */
static int32_t unit_of(const struct pel_linear *p)
{
    return p->base.cells * 256;
}

static int32_t magnitude(int32_t v)
{
    return v < 0 ? -v : v;
}

/* How the error changes to the pixel below. */
static int32_t row_of(const struct pel_linear *p)
{
    return p->d.x < 0 ? -p->d.y : p->d.y;
}

static PEL_CELL_STEP bool end_cells(struct pel_cells *c, int32_t count)
{
    const struct pel_linear *p = (const void *)c->gradient;
    int64_t error = c->end.error;
    int32_t part = c->rest;
    for (; count > 0; count--) {
        error -= p->cell;
        if (part < p->cell_rest) {
            part += unit_of(p);
            error--;
        }
        part -= p->cell_rest;
    }
    c->end.error = error;
    c->rest = part;
    return pel_cells_end(c, row_of(p), 0);
}

/* The copy of the way that has a product, from which it is left in the error.
 * Of a product < 0, all bits turned round are divided and turned back. */
static PEL_NOINLINE_32 int32_t find_copy(struct pel_cells *c,
                                         const struct pel_linear *p,
                                         int64_t product)
{
    const bool below = product < 0;
    uint64_t rest;
    const int32_t copy = (int32_t)pel_divide_64(
        (uint64_t)(below ? ~product : product), (uint64_t)p->square, &rest);
    c->end.error = below ? p->square - 1 - (int64_t)rest : (int64_t)rest;
    if (p->base.period == 0 && (p->d.x < 0 ? copy > 0 : below))
        c->end.error = product;
    return below ? ~copy : copy;
}

/* The cell of the first pixel: in the first row, or the row where it is lowest,
 * from where the error is taken to the first. Before a padded way it is in the
 * first cell all the same. n error < 2^15 2^49. */
static PEL_NOINLINE_32 void set_cell(struct pel_cells *c,
                                     const struct pel_linear *p, int32_t copy)
{
    const bool falling = p->d.x < 0;
    const int32_t n = p->base.cells;
    int64_t *const error = &c->end.error;
    uint64_t rest;
    if (p->base.period == 0 && (falling ? copy > 0 : copy < 0)) {
        c->place = falling ? n - 1 : 0;
        *error = falling ? p->square - *error : *error;
        c->rest = n * (int32_t)(*error & 255) - falling;
        *error >>= 8;
        return;
    }
    c->place = pel_gradient_place(
        &p->base, copy,
        (int32_t)pel_divide_64(pel_times((uint64_t)*error, n),
                               (uint64_t)p->square, &rest));
    if (!PEL_KNOW_SIDES && p->d.x == 0)
        return;
    if (falling)
        rest = (uint64_t)p->square - 1 - rest;
    *error = (int64_t)pel_divide_64(rest, (uint64_t)unit_of(p), &rest);
    c->rest = (int32_t)rest;
}

static PEL_ALWAYS_INLINE void start(struct pel_cells *c,
                                    const struct pel_linear *p)
{
    const int32_t row = row_of(p);
    const int32_t last =
        PEL_CELL_ROWS > 1 && row < 0 ? (c->cell.n - 1) * c->cell.step : 0;
    set_cell(c, p, find_copy(c, p, product_at(p, c->end.x, c->cell.y + last)));
    if (PEL_CELL_ROWS > 1)
        c->end.error -= pel_product(row, last);
    c->end.step = magnitude(p->d.x);
    if (p->d.x < 0)
        c->way = -1;
    if (p->d.x == 0)
        c->limit = 0;
}

/* From a row of a gradient that is level and grows downwards to the next one: a
 * few cells on, without a division. */
static void move_down(struct pel_cells *c, const struct pel_linear *p)
{
    const struct pel_gradient *g = &p->base;
    c->end.error += p->d.y;
    while (c->end.error > p->cell ||
           (c->end.error == p->cell && c->rest >= p->cell_rest)) {
        const bool carry = c->rest < p->cell_rest;
        c->end.error -= p->cell + carry;
        c->rest += (carry ? unit_of(p) : 0) - p->cell_rest;
        if (++c->place == g->period)
            c->place = 0;
        else if (g->period == 0)
            c->place = pel_min(c->place, g->cells - 1);
    }
}

/* Of a level gradient every row is one run of one cell. */
static void fill_level(struct pel_cells *c, const struct pel_linear *p,
                       const struct pel_spans *spans)
{
    const bool near_cells = p->d.y > 0 && p->d.y >> 3 <= p->cell;
    c->cell.n = 1;
    for (int32_t i = 0; i < spans->n; i++, c->cell.y += c->cell.step) {
        if (i == 0 || !near_cells)
            set_cell(c, p, find_copy(c, p, product_at(p, 0, c->cell.y)));
        else if (c->cell.step)
            move_down(c, p);
        pel_cells_first(c);
        c->run[0] = spans->span[i];
        pel_fill_value(&c->cell, c->value, c->opaque);
    }
}

/* Where boundaries lie far apart from row to row, the rows are drawn one by
 * one, and where cells are narrower than 1/16 px, so are pixels. */
static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    const struct pel_linear *p = (const void *)paint;
    const bool far = magnitude(p->d.y) > 8 * magnitude(p->d.x);
    const int32_t most = p->by_pixel || far ? 1 : PEL_CELL_ROWS;
    struct pel_cells c;
    pel_cells_open(&c, &p->base, spans);
    if (PEL_KNOW_SIDES && p->d.x == 0) {
        fill_level(&c, p, spans);
        return;
    }
    while (pel_cells_next(&c, most)) {
        if (p->by_pixel)
            c.hi = c.end.x + 1;
        start(&c, p);
        pel_cells_draw(&c, end_cells);
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
    paint->cell = (int64_t)pel_divide_64((uint64_t)paint->square,
                                         (uint64_t)unit_of(paint), &rest);
    paint->cell_rest = (int32_t)rest;
    paint->by_pixel =
        paint->base.period && magnitude(paint->d.x) > 16 * paint->cell;
    return PEL_OK;
}
