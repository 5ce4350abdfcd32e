#include "paint_linear.h"

#include <string.h>

#include "../base/divide.h"
#include "cells.h"

enum { PIECE_SIZE = PEL_64BIT ? 8192 : 512 }; /* bytes of a row */
enum { WIDEST = PEL_VECTORS ? 3 : 7 }; /* px: only narrower cells are walked */

/* (P - from).d of a point. */
static PEL_INLINE_FAST int64_t along(const struct pel_linear *p, int32_t x,
                                     int32_t y)
{
    return pel_product(x - p->from.x, p->d.x) +
           pel_product(y - p->from.y, p->d.y);
}

/* The product (P - from).d at pixel (x, y), or another that shows the same. Of
 * a padded way it is above -2^47, and |d|^2 at most. Of others lengths of two
 * ways, there and back, are taken away or added until it is above 0, and 2
 * |d|^2 at most: below 2^50. */
static int64_t product_at(const struct pel_linear *p, int32_t x, int32_t y)
{
    int64_t product = along(p, pel_pixel_center(x), pel_pixel_center(y));
    int64_t step = p->square;
    if (p->base.ramp.spread == PEL_PAD)
        return product < step ? product : step;
    int32_t count = 0;
    for (; (uint32_t)(step >> 32) >> 17 == 0; count++)
        step *= 2;
    for (product += step; count; count--, step >>= 1)
        if (product > step)
            product -= step;
    return product;
}

/* The error of the boundary where cell k begins is n product - k square, less 1
 * where the way is turned: there boundaries belong to the cells before them.
 * Where it is walked in 32 bits, it is counted in units of 256 n, by which n
 * product grows from pixel to pixel, and what they leave, c->rest. */
static int32_t unit_of(const struct pel_linear *p)
{
    return p->base.cells * 256;
}

/* From the boundary of a cell to that of the next. */
static inline void next_boundary(struct pel_cells *c,
                                 const struct pel_linear *p)
{
    c->error -= p->cell;
    c->rest -= p->cell_rest;
    if (c->rest < 0) {
        c->rest += unit_of(p);
        c->error--;
    }
}

static PEL_INLINE_FAST bool end_cells(struct pel_cells *c, int32_t count)
{
    const struct pel_linear *p = (const void *)c->gradient;
    if (PEL_CELL_ROWS == 1) {
        int64_t error = c->error - p->square;
        for (; error < 0 && c->x < c->hi; c->x++)
            error += p->step;
        c->error = error;
        return c->x < c->hi;
    }
    do
        next_boundary(c, p);
    while (--count);
    return pel_cells_end(c, p->d.x, p->d.y, 0);
}

/* The cell k of a pixel by its product, bit by bit of n, so that the error
 * where it begins is 0 or more and below square. Before a padded way it is the
 * first cell, behind it the last one. */
static PEL_NOINLINE_32 void set_cell(struct pel_cells *c,
                                     const struct pel_linear *p,
                                     int64_t product)
{
    const int32_t mirror = p->way >> 31; /* -1 when turned, or 0 */
    c->way = p->way;
    int64_t error = mirror;
    /* n in the 15 upper bits makes room for k in the lower ones. */
    uint32_t bits = (uint32_t)p->base.cells << 17;
    for (int i = 15; i; i--) {
        error = 2 * error - mirror;
        if ((int32_t)bits < 0)
            error += product;
        for (bits *= 2; error >= p->square; bits++)
            error -= p->square;
    }
    const int32_t n = p->base.cells, period = p->base.period;
    int32_t place = mirror ? n - 1 - (int32_t)bits : (int32_t)bits;
    while (place >= period)
        place -= p->base.ramp.spread == PEL_PAD ? 1 : period;
    c->place = place < 0 ? place + period : place;
    if (PEL_CELL_ROWS > 1) {
        int64_t rest;
        error = pel_divide_64(error, unit_of(p), &rest);
        c->rest = (int32_t)rest;
    }
    c->error = error;
}

/* From the row where the first pixel's product is lowest to the first. */
static PEL_ALWAYS_INLINE void start(struct pel_cells *c)
{
    const struct pel_linear *p = (const void *)c->gradient;
    const int32_t last =
        PEL_CELL_ROWS > 1 && p->d.y < 0 ? (c->cell.n - 1) * c->cell.step : 0;
    set_cell(c, p, product_at(p, c->x, c->cell.y + last));
    if (PEL_CELL_ROWS > 1)
        c->error -= pel_product(p->d.y, last);
}

/* A row of a vertical gradient has one color. Neighbouring rows of one pixel
 * value are drawn together. */
static void fill_level(const struct pel_linear *p,
                       const struct pel_spans *spans)
{
    const int32_t growth = spans->step ? p->d.y : 0;
    const bool narrow = growth >> 3 > p->cell; /* to walk them takes longer */
    struct pel_cells c;
    struct pel_spans rows = *spans;
    pel_cells_open(&c, &p->base, spans);
    for (int32_t left = spans->n; left > 0; left -= rows.n) {
        if (left == spans->n || narrow) {
            set_cell(&c, p, product_at(p, 0, rows.y));
            pel_cells_color(&c);
        }
        const uint32_t value = c.value;
        void (*const draw)(const struct pel_spans *, uint32_t) = c.draw;
        int32_t count = narrow ? 0 : pel_cells_pass(&c);
        rows.n = narrow ? 1 : left;
        if (count > 0) {
            do
                next_boundary(&c, p);
            while (--count);
            for (rows.n = 0; c.error < 0 && rows.n < left; rows.n++)
                c.error += growth;
        }
        if (rows.n > 0)
            pel_fill_value(&rows, value, draw);
        rows.span += rows.n;
        rows.y += rows.n * rows.step;
    }
}

static bool is_opaque(const struct pel_ramp *ramp)
{
    pel_color all = ramp->colors[0];
    for (int32_t i = 1; i < ramp->n; i++)
        all &= ramp->colors[i];
    return pel_alpha(all) == 255;
}

/* Cells that begin anew may be narrow: less than 1/16 px. Where boundaries lie
 * far apart from row to row, and rows cross many of them, rows are drawn one by
 * one. */
static void fill_cells(const struct pel_paint *paint,
                       const struct pel_spans *spans)
{
    const struct pel_linear *p = (const void *)paint;
    const int64_t down = pel_size_of(p->d.y);
    const bool narrow =
        p->base.ramp.spread != PEL_PAD && p->step >> 4 >= p->square;
    const bool far = PEL_CELL_ROWS > 1 && down > 32 * p->d.x && down > p->cell;
    const int32_t rows = far ? 1 : PEL_CELL_ROWS;
    pel_cells_fill(paint, spans, narrow ? 0 : rows, start, end_cells);
}

/* All rows of a horizontal gradient are alike, so pieces of one are drawn into
 * a buffer and copied from there: a screen may be slow to read. False: that
 * does not pay, or is wrong (colors are blended, pixels share bytes, or the
 * format is a dither's or the program's own). */
static bool fill_copies(const struct pel_linear *p,
                        const struct pel_spans *spans)
{
    struct pel_span hull;
    const int32_t bytes = spans->surface->format->bits / 8;
    uint32_t buffer[PIECE_SIZE / 4];
    struct pel_surface row = *spans->surface;
    row.pixels = buffer;
    if (bytes == 0 || row.format->id >= 128 || !is_opaque(&p->base.ramp) ||
        pel_spans_hull(&hull, spans->span, spans->n) < 2 * (hull.x1 - hull.x0))
        return false;
    for (struct pel_span piece = hull; piece.x0 < hull.x1;
         piece.x0 = piece.x1) {
        piece.x1 = pel_min(piece.x0 + PIECE_SIZE / bytes, hull.x1);
        row.bounds = (struct pel_rect){piece.x0, 0, piece.x1, 1};
        fill_cells(&p->base.paint, &(struct pel_spans){&row, &piece, 0, 1, 1});
        for (int32_t i = 0, y = spans->y; i < spans->n; i++, y += spans->step) {
            const int32_t x = pel_max(spans->span[i].x0, piece.x0);
            const int32_t n = pel_min(spans->span[i].x1, piece.x1) - x;
            if (n > 0)
                memcpy((void *)pel_address(spans->surface, x, y, bytes),
                       (void *)pel_address(&row, x, 0, bytes),
                       (size_t)(n * bytes));
        }
    }
    return true;
}

/* Fills the rows of a dither, which shows every cell, from the row where
 * products are least on. False, and nothing is done, unless the format can
 * walk, cells are 1/2 to WIDEST px wide (vectors are faster with others), and
 * the hull is all on one way from the first cell to the last: then errors are
 * below 256 WIDEST d.x < 2^30. */
static bool fill_walked(const struct pel_linear *p,
                        const struct pel_spans *spans)
{
    const struct pel_channels *const channels =
        spans->surface->format->channels;
    const int64_t growth = spans->step ? pel_size_of(p->d.y) : 0;
    const bool up = p->d.y < 0;
    const int32_t last = spans->n - 1;
    struct pel_span hull;
    struct pel_cells c;
    if (!channels || !channels->walk || p->base.ramp.n != 2 ||
        !is_opaque(&p->base.ramp) || p->cell >= pel_product(WIDEST, p->d.x) ||
        p->d.x >= 2 * p->cell || !pel_spans_hull(&hull, spans->span, spans->n))
        return false;
    const int64_t least =
        product_at(p, hull.x0, spans->y + up * last * spans->step);
    const int64_t across = pel_product(p->d.x, hull.x1 - 1 - hull.x0);
    if (least <= 0 || least + 256 * (across + growth * last) >= p->square)
        return false;
    c.gradient = &p->base;
    set_cell(&c, p, least);
    next_boundary(&c, p);
    for (int32_t i = 0; i <= last; i++, c.error += growth) {
        for (; c.error >= 0; next_boundary(&c, p))
            pel_cells_go(&c);
        const int32_t k = up ? last - i : i;
        const struct pel_span run = spans->span[k];
        if (run.x0 >= run.x1)
            continue;
        const struct pel_mix mix = pel_mix_from(&p->base, c.place, p->way);
        const int32_t error = (int32_t)c.error + p->d.x * (run.x0 - hull.x0);
        const struct pel_walk walk = {
            mix,          error,      c.rest, (int32_t)p->cell,
            p->cell_rest, unit_of(p), p->d.x};
        if (!channels->walk(spans->surface, run.x0, spans->y + k * spans->step,
                            run.x1 - run.x0, &walk))
            return false;
    }
    return true;
}

static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    const struct pel_linear *p = (const void *)paint;
    if (PEL_CELL_ROWS > 1 && p->d.x == 0)
        fill_level(p, spans);
    else if (PEL_CELL_ROWS == 1 ||
             ((p->d.y || !fill_copies(p, spans)) && !fill_walked(p, spans)))
        fill_cells(paint, spans);
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
    paint->base.paint.fill = fill;
    const int32_t onward = d.x || PEL_CELL_ROWS == 1 ? d.x : d.y;
    paint->way = (onward > 0) - (onward < 0);
    if (paint->way < 0) {
        from = to;
        d = (struct pel_point){-d.x, -d.y};
    }
    paint->from = from;
    paint->d = d;
    paint->square = along(paint, from.x + d.x, from.y + d.y);
    paint->step = pel_product(unit_of(paint), d.x);
    if (PEL_CELL_ROWS > 1) {
        int64_t rest;
        paint->cell = pel_divide_64(paint->square, unit_of(paint), &rest);
        paint->cell_rest = (int32_t)rest;
    }
    return PEL_OK;
}
