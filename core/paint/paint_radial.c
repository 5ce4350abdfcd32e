#include "paint_radial.h"

#include "../base/divide.h"
#include "cells.h"

/* One side of the rings, left or right of the centre. Squares of distances are
 * counted in 512ths: from pixel to pixel and from row to row they grow by whole
 * ones, so that what is left of them, p->low, never changes. A pixel lies
 * beyond a circle on the right side when the square of its distance is larger
 * than that of the radius, on the left side when it is not.
 *
 * The present cell begins at a circle of the radius floor(k radius / n), cells'
 * `whole`, rest / n what the floor drops: k rings lie inside. */

int64_t pel_radial_square(const struct pel_radial *p, int32_t x, int32_t y)
{
    return pel_square(pel_pixel_center(x) - p->rings.center.x) +
           pel_square(pel_pixel_center(y) - p->rings.center.y);
}

/* Adds the square of the present circle's radius, in 512ths, to the error, or
 * takes it away. No circles lie inside the centre. */
static PEL_NOINLINE_32 void add_circle(struct pel_cells *c,
                                       const struct pel_radial *p, int32_t way)
{
    const int64_t square = (pel_square(pel_max(c->whole, 0)) - p->low) >> 9;
    c->error += way < 0 ? -square : square;
}

static PEL_INLINE_FAST bool end_cells(struct pel_cells *c, int32_t count)
{
    const struct pel_radial *p = (const void *)c->gradient;
    const struct pel_point center = p->rings.center;
    const int32_t way = c->way;
    add_circle(c, p, way);
    pel_cells_move(c, count, p->width, p->rest, p->base.cells);
    add_circle(c, p, -way);
    return pel_cells_end(c, way * (pel_pixel_center(c->x) - center.x + 128),
                         way * (pel_pixel_center(c->cell.y) - center.y + 128),
                         way * 256);
}

/* The row of the pixel where the walk begins: the farthest from the centre on
 * the left side, the nearest on the right. */
static int32_t first_row(const struct pel_cells *c, int32_t center)
{
    const int32_t y = c->cell.y, end = y + (c->cell.n - 1) * c->cell.step + 1;
    if (PEL_CELL_ROWS == 1)
        return y;
    return c->way > 0 ? pel_nearest_pixel(y, end, center)
                      : pel_farthest_pixel(y, end, center);
}

/* Of the square of a distance, below 2^51, in the error: its root, rounded up,
 * less 1, bit by bit. 0 of 0. */
static PEL_NOINLINE_32 void find_root(struct pel_cells *c)
{
    c->whole = 0;
    for (int32_t bit = 1 << 25; bit; bit >>= 1)
        if (pel_square(c->whole + bit) < c->error)
            c->whole += bit;
}

static int32_t quotient(int64_t n, int32_t d)
{
    return (int32_t)pel_divide((uint64_t)n, (uint32_t)d);
}

/* The ring that holds the pixel, its place, and the circle where it begins. It
 * is the largest k with k radius / n < u, the root rounded up, which is k <=
 * (u n - 1) / radius. On the left side rings begin at the outer circle, unless
 * the last cell of a padded way begins farther inside. */
static PEL_NOINLINE_32 void find_ring(struct pel_cells *c,
                                      const struct pel_radial *p)
{
    const int32_t radius = p->rings.radius, n = p->base.cells;
    const int32_t most = n - 1 - p->first, some = c->error != 0;
    int32_t copy = quotient(c->whole, radius);
    int32_t part = quotient(
        pel_product(c->whole - copy * radius + some, n) - some, radius);
    if (c->way < 0 && p->base.ramp.spread == PEL_PAD && (copy || part > most)) {
        copy = 0;
        part = most;
    }
    const bool beyond = part > most;
    c->place = pel_cells_place(&p->base, copy + beyond,
                               part + p->first - (beyond ? n : 0));
    const int64_t ring = pel_product(part + (c->way < 0), radius);
    const int32_t begin = quotient(ring, n);
    c->whole = copy * radius + begin;
    c->rest = (int32_t)((uint32_t)ring - (uint32_t)begin * (uint32_t)n);
}

/* The part of the batch on one side. */
static PEL_ALWAYS_INLINE void start(struct pel_cells *c)
{
    const struct pel_radial *p = (const void *)c->gradient;
    const int32_t split = pel_first_pixel(p->rings.center.x);
    c->way = 1;
    if (c->x < split) {
        c->way = -1;
        c->hi = pel_min(c->hi, split);
    }
    c->error = pel_radial_square(p, c->x, first_row(c, p->rings.center.y));
    find_root(c);
    find_ring(c, p);
    c->error = (pel_radial_square(p, c->x, c->cell.y) >> 9) - 1;
    if (c->way < 0)
        c->error = ~c->error;
    add_circle(c, p, -c->way);
}

static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    const struct pel_radial *p = (const void *)paint;
    const bool narrow = p->base.ramp.spread != PEL_PAD &&
                        p->rings.radius < 4 * p->base.cells; /* than 1/64 px */
    if (!(PEL_FAST_FILLS && PEL_64BIT && pel_radial_fast(p, spans)))
        pel_cells_fill(paint, spans, narrow ? 0 : PEL_CELL_ROWS, start,
                       end_cells);
}

enum pel_status pel_radial_init(struct pel_radial *paint,
                                const struct pel_rings *rings,
                                const struct pel_ramp *ramp)
{
    const enum pel_status status =
        pel_gradient_init((void *)paint, rings ? ramp : NULL);
    if (status != PEL_OK)
        return status;
    if (!pel_point_legal(rings->center) || rings->radius < 256 ||
        rings->radius > PEL_PX(32767))
        return PEL_ERROR_RANGE;
    const int32_t n = paint->base.cells;
    paint->base.paint.fill = fill;
    paint->rings = *rings;
    paint->first = (int32_t)((uint32_t)rings->phase * (uint32_t)n >> 16);
    paint->width = quotient(rings->radius, n);
    paint->rest = rings->radius - paint->width * n;
    paint->low = (uint32_t)pel_radial_square(paint, 0, 0) & 511;
    return PEL_OK;
}
