#include "paint_linear.h"

#include <string.h>

#include "../base/divide.h"
#include "linear_walk.h"

/* The way is drawn from the end on the left, so that products do not fall to
 * the right. 1 where that is the end of the last cell: there the boundaries
 * belong to the cells before them. */
static inline int32_t turned(const struct pel_linear *p)
{
    return (int32_t)((uint32_t)p->way >> 31);
}

/* (P - from).d of a point. */
static PEL_INLINE_FAST int64_t along(const struct pel_linear *p, int32_t x,
                                     int32_t y)
{
    return pel_product(x - p->from.x, p->d.x) +
           pel_product(y - p->from.y, p->d.y);
}

/* The product (P - from).d - turned at pixel (x, y), below 2^49, and above
 * -2^47 before the way; or another that shows the same. Of a padded way none is
 * beyond the end; of others it is less as many times two lengths, there and
 * back, as leave 0 or more. */
static PEL_NOINLINE_32 int64_t product_at(const struct pel_linear *p, int32_t x,
                                          int32_t y)
{
    int64_t product =
        along(p, pel_pixel_center(x), pel_pixel_center(y)) - turned(p);
    int64_t step = p->square;
    int32_t count = 0;
    if (p->base.period == 0)
        return product < step ? product : step - 1;
    do {
        step *= 2;
        count++;
    } while ((uint32_t)(step >> 32) >> 17 == 0);
    product += step;
    do {
        if (product >= step)
            product -= step;
        step >>= 1;
    } while (--count);
    return product;
}

/* The error of the boundary where cell k begins is n product - turned - k
 * square. Where it is walked in 32 bits, it is counted in units of 256 n, by
 * which n product grows from pixel to pixel, and what they leave, c->rest. */
static int32_t unit_of(const struct pel_linear *p)
{
    return p->base.cells * 256;
}

static PEL_INLINE_FAST bool end_cells(struct pel_cells *c, int32_t count)
{
    const struct pel_linear *p = (const void *)c->gradient;
    int64_t error = c->error;
    if (PEL_CELL_ROWS == 1) {
        error -= p->square;
        for (; error < 0 && c->x < c->hi; c->x++)
            error += p->step;
        c->error = error;
        return c->x < c->hi;
    }
    int32_t part = c->rest;
    do {
        error -= p->cell;
        part -= p->cell_rest;
        if (part < 0) {
            part += unit_of(p);
            error--;
        }
    } while (--count);
    c->error = error;
    c->rest = part;
    return pel_cells_end(c, p->d.x, p->d.y, 0) < 0;
}

/* The cell of the pixel that has a product, less `turned`: k = floor((n product
 * - turned) / square), bit by bit of n, and the error where it begins. Before a
 * padded way it is the first cell all the same. */
static PEL_NOINLINE_32 void set_cell(struct pel_cells *c,
                                     const struct pel_linear *p,
                                     int64_t product)
{
    const int32_t mirror = p->way >> 31; /* -1 when turned, or 0 */
    product -= mirror;
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
    int32_t place = (int32_t)bits;
    const int32_t n = p->base.cells, period = p->base.period;
    if (period && place >= period)
        place -= period;
    place = (place ^ mirror) + (mirror & n);
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
    c->way = p->way;
    if (PEL_CELL_ROWS > 1)
        c->error -= pel_product(p->d.y, last);
}

/* Goes to a pixel whose error is greater by `growth`, or less: a few cells on
 * or back, without a division. Not back from a last cell that goes on. */
static void move(struct pel_cells *c, const struct pel_linear *p,
                 int64_t growth, int32_t way)
{
    const struct pel_gradient *const g = &p->base;
    c->error += growth;
    while (c->error > p->cell ||
           (c->error == p->cell && c->rest >= p->cell_rest)) {
        const bool carry = c->rest < p->cell_rest;
        c->error -= p->cell + carry;
        c->rest += (carry ? unit_of(p) : 0) - p->cell_rest;
        c->place = pel_cells_after(g, c->place, way);
    }
    while (c->error < 0 && pel_cells_after(g, c->place, -way) != c->place) {
        const bool carry = c->rest + p->cell_rest >= unit_of(p);
        c->error += p->cell + carry;
        c->rest += p->cell_rest - (carry ? unit_of(p) : 0);
        c->place = pel_cells_after(g, c->place, -way);
    }
}

/* A row of a vertical gradient has one color. Neighbouring rows of one pixel
 * value are drawn together. */
static void fill_level(const struct pel_linear *p,
                       const struct pel_spans *spans)
{
    struct pel_cells c;
    struct pel_spans rows = *spans;
    uint32_t value = 0;
    void (*draw)(const struct pel_spans *, uint32_t) = NULL;
    const bool near_cells = p->d.y > 0 && p->d.y >> 3 <= p->cell;
    pel_cells_open(&c, &p->base, spans);
    rows.n = 0;
    for (int32_t i = 0; i < spans->n; i++, c.cell.y += c.cell.step) {
        if (i == 0 || !near_cells)
            set_cell(&c, p, product_at(p, 0, c.cell.y));
        else if (c.cell.step)
            move(&c, p, p->d.y, 1);
        pel_cells_color(&c);
        if (rows.n && (c.value != value || c.draw != draw)) {
            pel_fill_value(&rows, value, draw);
            rows = (struct pel_spans){rows.surface, rows.span + rows.n,
                                      c.cell.y, 0, rows.step};
        }
        value = c.value;
        draw = c.draw;
        rows.n++;
    }
    pel_fill_value(&rows, value, draw);
}

static bool is_opaque(const struct pel_ramp *ramp)
{
    pel_color all = ramp->colors[0];
    for (int32_t i = 1; i < ramp->n; i++)
        all &= ramp->colors[i];
    return pel_alpha(all) == 255;
}

/* All rows of a horizontal gradient are alike, so one is drawn and copied to
 * the others: the row whose span holds all of theirs. -1: there is none, or
 * copies would be wrong (colors are blended, pixels share bytes, or the format
 * is a dither's or the program's own). */
static int32_t find_model(const struct pel_linear *p,
                          const struct pel_spans *spans)
{
    const struct pel_format *format = spans->surface->format;
    const struct pel_span *span = spans->span;
    int32_t model = 0, x0 = span->x0, x1 = span->x1;
    if (p->d.y != 0 || spans->n * spans->step < 2 || format->id >= 128 ||
        format->bits < 8)
        return -1;
    for (int32_t i = 1; i < spans->n; i++) {
        x0 = pel_min(x0, span[i].x0);
        x1 = pel_max(x1, span[i].x1);
        if (span[i].x0 == x0 && span[i].x1 == x1)
            model = i;
    }
    const bool holds = span[model].x0 == x0 && span[model].x1 == x1;
    return holds && is_opaque(&p->base.ramp) ? model : -1;
}

static void copy_model(const struct pel_spans *spans, int32_t model)
{
    const struct pel_surface *s = spans->surface;
    const int32_t bytes = s->format->bits / 8;
    for (int32_t i = 0; i < spans->n; i++) {
        const struct pel_span *span = &spans->span[i];
        if (i != model && span->x0 < span->x1)
            memcpy((void *)pel_address(s, span->x0, spans->y + i, bytes),
                   (void *)pel_address(s, span->x0, spans->y + model, bytes),
                   (size_t)((span->x1 - span->x0) * bytes));
    }
}

/* To a run's first pixel; to the shape's first one, if c->place < 0. */
static void move_to(struct pel_cells *c, const struct pel_linear *p, int32_t x,
                    int32_t y)
{
    const int64_t growth =
        pel_product(p->d.x, x - c->x) + pel_product(p->d.y, y - c->cell.y);
    const int64_t most = 64 * p->cell;
    const bool lost = c->place < 0 || growth > most || growth < -most;
    c->x = x;
    c->cell.y = y;
    if (lost ||
        (growth < 0 && pel_cells_after(&p->base, c->place, p->way) == c->place))
        set_cell(c, p, product_at(p, x, y));
    else
        move(c, p, growth, p->way);
}

/* False: nothing is done, or no more than pixels before the way. Only where the
 * format can walk, and cells are 1/2 to 7 px wide. */
static bool fill_walked(const struct pel_linear *p,
                        const struct pel_spans *spans)
{
    const struct pel_channels *const channels =
        spans->surface->format->channels;
    struct pel_cells c;
    if (!channels || !channels->walk || p->base.ramp.n != 2 ||
        !is_opaque(&p->base.ramp) || p->cell >= 7 * (int64_t)p->d.x ||
        p->d.x >= 2 * p->cell)
        return false;
    pel_cells_open(&c, &p->base, spans);
    c.x = 0;
    c.place = -1;
    for (int32_t i = 0; i < spans->n; i++) {
        const struct pel_span run = spans->span[i];
        if (run.x0 >= run.x1)
            continue;
        move_to(&c, p, run.x0, spans->y + i * spans->step);
        if (!pel_walk_run(&c, p, run.x1))
            return false;
    }
    return true;
}

/* Where boundaries lie far apart from row to row, the rows are drawn one by
 * one, and where cells are narrower than 1/16 px, so are pixels. */
static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    const struct pel_linear *p = (const void *)paint;
    const bool far = pel_size_of(p->d.y) > 8 * p->d.x;
    const int32_t most = PEL_CELL_ROWS == 1 || far ? 1 : PEL_CELL_ROWS;
    const int32_t model = PEL_CELL_ROWS > 1 ? find_model(p, spans) : -1;
    struct pel_spans drawn = *spans;
    if (model >= 0) {
        drawn.span += model;
        drawn.y += model;
        drawn.n = 1;
    }
    if (PEL_CELL_ROWS > 1 && p->d.x == 0)
        fill_level(p, spans);
    else if (PEL_CELL_ROWS == 1 || !fill_walked(p, &drawn))
        pel_cells_fill(paint, &drawn, most, start, end_cells);
    if (model >= 0)
        copy_model(spans, model);
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
    paint->way = (d.x > 0) - (d.x < 0);
    if (d.x < 0) {
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
        paint->base.by_pixel =
            paint->base.period &&
            (uint32_t)(paint->step >> 21) >= (uint32_t)(paint->square >> 17);
    }
    return PEL_OK;
}
