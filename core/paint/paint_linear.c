#include "paint_linear.h"

#include "../base/divide.h"
#include "cells.h"

enum { FAR = 1 << 18 }; /* px: beyond every pixel, seen from any other */

/* (P - from).d at pixel (x, y). Below 2^50. */
static int64_t product_at(const struct pel_linear *p, int32_t x, int32_t y)
{
    return pel_product(pel_pixel_center(x) - p->from.x, p->d.x) +
           pel_product(pel_pixel_center(y) - p->from.y, p->d.y);
}

/* The boundaries of a linear gradient are parallel lines. A pixel lies beyond
 * number k when its product is at least k square / n, rounded up (and from `to`
 * when it is more). In the first row that is the pixel floor(f / (256 d.x)),
 * with an f that grows by square / n from one boundary to the next. */
struct lines {
    struct pel_cells cells;
    union {
        struct {
            int32_t x;  /* where the present cell ends: of f the quotient, */
            uint32_t m; /* and what is left, below 256 d.x */
        } end;
        uint64_t gone; /* at the start: the product of the first pixel, from its
                          copy of the way on */
    } at;
    uint32_t part; /* of the rounding what is left, in 1/n */
};

/* A cell of copy number `copy` of the way. */
static int32_t place_of(const struct pel_linear *p, int32_t copy, int32_t part)
{
    const int32_t place = pel_gradient_place(&p->base, copy, part);
    if (!p->reversed)
        return place;
    const int32_t mirrored = p->base.cells - 1 - place;
    return mirrored < 0 ? mirrored + p->base.period : mirrored;
}

/* The cell of a pixel; 0 <= gone < square, and n gone < 2^15 2^49. Seen from
 * `to`, who is on a boundary is still before it: it belongs to the cell that
 * begins there for who comes from `from`. Of a product < 0, all bits turned
 * round are divided and turned back. Before a padded way the first cell ends
 * where the second begins. */
static PEL_NOINLINE_32 void set_cell(struct lines *l,
                                     const struct pel_linear *p,
                                     int64_t product)
{
    const uint64_t square = (uint64_t)p->square;
    uint64_t rest;
    int32_t copy = (int32_t)pel_divide_64(
        (uint64_t)(product < 0 ? ~product : product), square, &l->at.gone);
    if (product < 0) {
        copy = ~copy;
        l->at.gone = square - 1 - l->at.gone;
    }
    int32_t part = (int32_t)pel_divide_64(pel_times(l->at.gone, p->base.cells),
                                          square, &rest);
    if (p->reversed && rest == 0 && part-- == 0) {
        part += p->base.cells;
        l->at.gone += square;
        copy--;
    }
    l->cells.place = place_of(p, copy, part);
    if (p->base.period == 0 && copy < 0) {
        part = 0;
        l->at.gone = (uint64_t)product;
    }
    l->part = (uint32_t)part;
}

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
static PEL_CELL_STEP void next_lines(struct lines *l,
                                     const struct pel_linear *p, int32_t count)
{
    const uint32_t width = (uint32_t)p->d.x << 8, n = (uint32_t)p->base.cells;
    const uint32_t cell_rest = p->cell_rest, part_rest = p->part_rest;
    const int32_t cell = p->cell;
    uint32_t m = l->at.end.m, part = l->part;
    int32_t x = l->at.end.x;
    for (; count > 0 && x < 2 * FAR; count--) {
        x += cell;
        line_add(&x, &m, width, cell_rest);
        part += part_rest;
        if (part >= n) {
            part -= n;
            line_add(&x, &m, width, 1);
        }
    }
    l->at.end.x = x;
    l->at.end.m = m;
    l->part = part;
}

/* An edge does without the lowest 8 bits, which never change from row to row.
 */
static PEL_CELL_STEP bool end_at_lines(struct lines *l,
                                       const struct pel_linear *p)
{
    struct pel_edge edge = {l->at.end.x, (int32_t)(l->at.end.m >> 8) - p->d.x,
                            p->down, p->down_rest, p->d.x};
    return pel_cells_end_at(&l->cells, &edge);
}

static PEL_CELL_STEP bool end_cells(struct pel_cells *cells, int32_t count)
{
    const struct pel_linear *p = (const void *)cells->gradient;
    struct lines *l = (void *)cells;
    next_lines(l, p, count - 1);
    const bool rest = end_at_lines(l, p);
    next_lines(l, p, 1);
    return rest;
}

/* The boundary after the first pixel's cell, number `part`, where it crosses
 * the row of that pixel, x. */
static PEL_NOINLINE_32 void set_end(struct lines *l, const struct pel_linear *p,
                                    int32_t x0)
{
    const uint32_t n = (uint32_t)p->base.cells, width = (uint32_t)p->d.x << 8;
    uint64_t way = pel_times((uint64_t)p->square, (int32_t)l->part + 1) + n -
                   1 + p->reversed;
    const uint32_t high = pel_divide(way >> 32, n);
    way -= (uint64_t)(high * n) << 32;
    const uint32_t low = pel_divide(way, n);
    l->part = (uint32_t)way - low * n;
    way = ((uint64_t)high << 32 | low) - l->at.gone + width - 1;
    const uint32_t x = way >> 18 < width ? pel_divide(way, width) : FAR;
    l->at.end.x = x0 + (int32_t)x;
    l->at.end.m = x < FAR ? (uint32_t)way - x * width : 0;
}

/* To the product of the first pixel, which is in the last row where boundaries
 * lean to the right. */
static PEL_NOINLINE_32 int64_t first_product(const struct lines *l,
                                             const struct pel_linear *p,
                                             int32_t x0)
{
    const struct pel_spans *rows = &l->cells.cell;
    const int32_t span = p->d.y < 0 ? (rows->n - 1) * rows->step : 0;
    return product_at(p, x0, rows->y + span);
}

/* From the last row to the first. */
static PEL_NOINLINE_32 void back(struct lines *l, const struct pel_linear *p)
{
    const struct pel_spans *rows = &l->cells.cell;
    for (int32_t i = (rows->n - 1) * rows->step; i > 0; i--) {
        l->at.end.x -= p->down + 1;
        line_add(&l->at.end.x, &l->at.end.m, (uint32_t)p->d.x << 8,
                 (uint32_t)(p->d.x - p->down_rest) << 8);
    }
}

/* In the cell of the first pixel on the way, or before it. */
static PEL_ALWAYS_INLINE void start(struct lines *l, const struct pel_linear *p,
                                    int32_t x0)
{
    set_cell(l, p, first_product(l, p, x0));
    l->cells.step = p->reversed ? -1 : 1;
    if (p->d.x == 0) {
        l->cells.limit = 0;
        return;
    }
    set_end(l, p, x0);
    if (p->d.y < 0)
        back(l, p);
}

/* A function of its own, to spare the stack of what comes before it. */
static PEL_NOINLINE_32 void walk(struct lines *l)
{
    pel_cells_draw(&l->cells, end_cells);
}

/* The first pixel of the next batch. Where boundaries lie far apart from row to
 * row, above 129 pixels, the rows are drawn one by one. */
static PEL_CELL_STEP int32_t next(struct lines *l, const struct pel_linear *p,
                                  const struct pel_spans *spans)
{
    const bool alone =
        p->by_pixel || p->d.x == 0 || p->down > 128 || p->down < -128;
    const int32_t x0 =
        pel_cells_next(&l->cells, spans, alone ? 1 : PEL_CELL_ROWS);
    if (p->by_pixel && x0 < INT32_MAX)
        l->cells.stop = x0 + 1;
    return x0;
}

static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    const struct pel_linear *p = (const void *)paint;
    struct lines l;
    pel_cells_open(&l.cells, &p->base, spans);
    for (int32_t x0; (x0 = next(&l, p, spans)) < INT32_MAX;) {
        start(&l, p, x0);
        walk(&l);
    }
}

static void set_steps(struct pel_linear *p)
{
    const int32_t n = p->base.cells, dy = p->d.y < 0 ? -p->d.y : p->d.y;
    uint64_t rest;
    p->square = pel_square(p->d.x) + pel_square(p->d.y);
    p->by_pixel =
        p->base.period && pel_long_product(p->d.x + dy, n * 16) > p->square;
    if (p->d.x == 0)
        return;
    uint64_t q = pel_divide_64((uint64_t)p->square, (uint64_t)n, &rest);
    p->part_rest = (uint32_t)rest;
    q = pel_divide_64(q, (uint64_t)p->d.x * 256, &rest);
    p->cell = q > FAR ? FAR : (int32_t)q;
    p->cell_rest = (uint32_t)rest;
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
