#include "paint_linear.h"

#include "../base/divide.h"
#include "cells.h"

/* The way is drawn from the end on the left, so that products do not fall to
 * the right; where that is the end of the last cell, the boundaries belong to
 * the cells before them, and products are 1 less: (P - from).d at pixel (x, y).
 * Below 2^50, and above -2^47 before the way. */
static PEL_NOINLINE_32 int64_t product_at(const struct pel_linear *p, int32_t x,
                                          int32_t y)
{
    return pel_product(pel_pixel_center(x) - p->from.x, p->d.x) +
           pel_product(pel_pixel_center(y) - p->from.y, p->d.y) - p->turned;
}

/* The error of the boundary where cell k begins is n product - k square, where
 * the 1 is not taken n times: whole units of 256 n, by which it grows from
 * pixel to pixel, and what they leave, c->rest. */
static uint64_t unit_of(const struct pel_linear *p)
{
    return (uint32_t)p->base.cells * 256;
}

static PEL_CELL_STEP bool end_cells(struct pel_cells *c, int32_t count)
{
    const struct pel_linear *p = (const void *)c->gradient;
    int64_t error = c->end.error;
    int32_t part = c->rest;
    do {
        error -= p->cell;
        part -= p->cell_rest;
        if (part < 0) {
            part += (int32_t)unit_of(p);
            error--;
        }
    } while (--count);
    c->end.error = error;
    c->rest = part;
    return pel_cells_end(c, p->d.y, 0);
}

/* The cell that has a product, and the error where it begins. Before a padded
 * way it is the first cell all the same. */
static PEL_NOINLINE_32 void set_cell(struct pel_cells *c,
                                     const struct pel_linear *p,
                                     int64_t product)
{
    const struct pel_gradient *g = &p->base;
    const int32_t n = g->cells;
    const bool before = product < 0 && g->period == 0;
    uint64_t *const rest = (uint64_t *)&c->end.error;
    int32_t copy = 0, part = 0;
    if (!before) {
        *rest = product < 0 ? (uint64_t)p->square - 1 : 0;
        copy = (int32_t)pel_divide_64((uint64_t)product, (uint64_t)p->square,
                                      rest);
        product = (int64_t)*rest;
    }
    uint64_t error =
        pel_times((uint64_t)product, n) + (uint32_t)((n - 1) * p->turned);
    *rest = before ? unit_of(p) - 1 : 0;
    if (!before) {
        part = (int32_t)pel_divide_64(error, (uint64_t)p->square, rest);
        error = *rest;
        *rest = 0;
    }
    c->place = pel_cells_place(g, copy, part);
    if (p->turned) {
        c->place = g->cells - 1 - c->place;
        if (c->place < 0)
            c->place += g->period;
    }
    error = pel_divide_64(error, unit_of(p), rest);
    c->rest = (int32_t)*rest;
    c->end.error = (int64_t)error;
}

/* From the row where the first pixel's product is lowest to the first. */
static PEL_ALWAYS_INLINE void start(struct pel_cells *c,
                                    const struct pel_linear *p)
{
    const int32_t last =
        PEL_CELL_ROWS > 1 && p->d.y < 0 ? (c->cell.n - 1) * c->cell.step : 0;
    set_cell(c, p, product_at(p, c->end.x, c->cell.y + last));
    if (PEL_CELL_ROWS > 1)
        c->end.error -= pel_product(p->d.y, last);
    c->end.step = p->d.x;
    if (p->turned)
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
        c->rest += (carry ? (int32_t)unit_of(p) : 0) - p->cell_rest;
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
            set_cell(c, p, product_at(p, 0, c->cell.y));
        else if (c->cell.step)
            move_down(c, p);
        pel_cells_color(c);
        c->run[0] = spans->span[i];
        pel_fill_value(&c->cell, c->value, c->opaque);
    }
}

/* Where boundaries lie far apart from row to row, the rows are drawn one by
 * one, and where cells are narrower than 1/16 px, so are pixels. */
static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    const struct pel_linear *p = (const void *)paint;
    const bool far = pel_size_of(p->d.y) > 8 * p->d.x;
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
    paint->turned = to.x < from.x;
    if (paint->turned) {
        const struct pel_point left = to;
        to = from;
        from = left;
    }
    paint->from = from;
    paint->d = (struct pel_point){to.x - from.x, to.y - from.y};
    paint->square = pel_square(paint->d.x) + pel_square(paint->d.y);
    uint64_t rest = 0;
    paint->cell =
        (int64_t)pel_divide_64((uint64_t)paint->square, unit_of(paint), &rest);
    paint->cell_rest = (int32_t)rest;
    paint->by_pixel = paint->base.period && paint->d.x > 16 * paint->cell;
    return PEL_OK;
}
