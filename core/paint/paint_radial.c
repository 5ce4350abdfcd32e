#include "paint_radial.h"

#include "../base/divide.h"
#include "cells.h"

/* A circle between rings: k of them lie inside, in copy number `copy` of the
 * way. Its radius is floor(k radius / n) exactly, rest / n what the floor
 * drops. */
struct circle {
    int32_t copy, part;
    int32_t radius, rest;
};

/* One side of the rings, left or right of the centre. Squares of distances are
 * counted in 512ths: from pixel to pixel and from row to row they grow by whole
 * ones, so that what is left of them, p->low, never changes. A pixel lies
 * beyond a circle on the right side when the square of its distance is larger
 * than that of the radius, on the left side when it is not. */
struct side {
    struct pel_cells cells;
    struct circle circle; /* where the present cell begins, */
    int64_t square;       /* and its square in 512ths */
};

static void circle_set(const struct pel_radial *p, int32_t copy, int32_t part,
                       struct circle *c)
{
    const uint32_t n = (uint32_t)p->base.cells;
    const uint64_t ring =
        pel_multiply((uint32_t)part, (uint32_t)p->rings.radius);
    const uint32_t inner = pel_divide(ring, n);
    c->copy = copy;
    c->part = part;
    c->radius = copy * p->rings.radius + (int32_t)inner;
    c->rest = (int32_t)((uint32_t)ring - inner * n);
}

/* To the next circle outwards, or inwards. */
static void circle_move(const struct pel_radial *p, struct circle *c,
                        int32_t way)
{
    c->radius += way * p->width;
    c->rest += way * p->rest;
    if (c->rest < 0 || c->rest >= p->base.cells) {
        c->rest -= way * p->base.cells;
        c->radius += way;
    }
}

static int64_t circle_square(const struct pel_radial *p, const struct circle *c)
{
    return (pel_square(c->radius) - p->low) >> 9;
}

static PEL_CELL_STEP bool end_cells(struct pel_cells *cells, int32_t count)
{
    const struct pel_radial *p = (const void *)cells->gradient;
    struct side *s = (void *)cells;
    const int64_t square = s->square;
    do
        circle_move(p, &s->circle, cells->way);
    while (--count);
    s->square = circle_square(p, &s->circle);
    cells->end.error -=
        cells->way > 0 ? s->square - square : square - s->square;
    const int32_t v = pel_pixel_center(cells->cell.y) - p->rings.center.y;
    return pel_cells_end(cells, cells->way * (v + 128), cells->way * 256);
}

static int64_t square_at(const struct pel_radial *p, int32_t x, int32_t y)
{
    return pel_square(pel_pixel_center(x) - p->rings.center.x) +
           pel_square(pel_pixel_center(y) - p->rings.center.y);
}

/* The row of the pixel where the walk begins: the farthest from the centre on
 * the left side, the nearest on the right. */
static int32_t first_row(const struct pel_cells *c, const struct pel_radial *p)
{
    const int32_t y = c->cell.y, last = y + (c->cell.n - 1) * c->cell.step;
    if (c->way > 0)
        return pel_min(pel_max(pel_pixel_of(p->rings.center.y), y), last);
    return 2 * p->rings.center.y - pel_pixel_center(y) > pel_pixel_center(last)
               ? y
               : last;
}

/* floor(sqrt(v)) for v < 2^52, bit by bit. */
static PEL_NOINLINE_32 uint32_t root_of(uint64_t v)
{
    uint64_t root = 0;
    for (uint64_t bit = UINT64_C(1) << 50; bit; bit >>= 2) {
        const uint64_t more = root + bit;
        root >>= 1;
        if (v >= more) {
            v -= more;
            root += bit;
        }
    }
    return (uint32_t)root;
}

/* The inner circle of the ring that holds a pixel. With u the root of the
 * square of its distance, rounded up, ring k holds it when k radius / n < u,
 * which is k <= (u n - 1) / radius. */
static PEL_NOINLINE_32 void find_ring(struct side *s,
                                      const struct pel_radial *p,
                                      int64_t square)
{
    const uint32_t radius = (uint32_t)p->rings.radius;
    const uint32_t n = (uint32_t)p->base.cells;
    const uint32_t some = square > 0;
    const uint32_t below = root_of((uint64_t)square - some); /* u - 1 */
    const uint32_t copy = pel_divide(below, radius);
    const uint32_t part = pel_divide(
        pel_multiply(below - copy * radius + some, n) - some, radius);
    circle_set(p, (int32_t)copy, (int32_t)part, &s->circle);
}

/* The place of the ring that was found, and the circle where it begins: on the
 * left side the outer one, unless the last cell of a padded way begins farther
 * inside. */
static PEL_NOINLINE_32 void set_ring(struct side *s, const struct pel_radial *p)
{
    struct pel_cells *c = &s->cells;
    struct circle *circle = &s->circle;
    const int32_t n = p->base.cells, most = n - 1 - p->first;
    if (c->way < 0) {
        if (p->base.period == 0 && (circle->copy || circle->part > most))
            circle_set(p, 0, most, circle);
        c->limit =
            circle->copy < 65535 ? circle->copy * n + circle->part : INT32_MAX;
        circle_move(p, circle, 1);
    }
    const int32_t beyond = circle->part > most;
    c->place = pel_gradient_place(&p->base, circle->copy + beyond,
                                  circle->part + p->first - beyond * n);
}

/* At the first pixel of the first row. */
static PEL_NOINLINE_32 void set_end(struct side *s, const struct pel_radial *p)
{
    struct pel_cells *c = &s->cells;
    struct pel_boundary *end = &c->end;
    const int32_t y = c->cell.y;
    s->square = circle_square(p, &s->circle);
    end->error = (square_at(p, c->end.x, y) >> 9) - s->square;
    end->error = c->way > 0 ? end->error - 1 : -end->error;
    end->step = c->way * (pel_pixel_center(c->end.x) - p->rings.center.x + 128);
}

/* The part of the batch on one side. Rings narrower than 1/64 px are drawn a
 * pixel at a time. */
static PEL_CELL_STEP void set_side(struct pel_cells *c,
                                   const struct pel_radial *p)
{
    const int32_t split = pel_first_pixel(p->rings.center.x);
    if (p->base.period && p->rings.radius < 4 * p->base.cells)
        c->hi = c->end.x + 1;
    if (c->end.x < split) {
        c->way = -1;
        c->hi = pel_min(c->hi, split);
    }
}

static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    const struct pel_radial *p = (const void *)paint;
    struct side s;
    pel_cells_open(&s.cells, &p->base, spans);
    while (pel_cells_next(&s.cells, spans, PEL_CELL_ROWS)) {
        set_side(&s.cells, p);
        find_ring(&s, p, square_at(p, s.cells.end.x, first_row(&s.cells, p)));
        set_ring(&s, p);
        set_end(&s, p);
        pel_cells_draw(&s.cells, end_cells);
    }
}

enum pel_status pel_radial_init(struct pel_radial *paint,
                                const struct pel_rings *rings,
                                const struct pel_ramp *ramp)
{
    if (!paint)
        return PEL_ERROR_NULL;
    pel_paint_clear(&paint->base.paint);
    if (!rings)
        return PEL_ERROR_NULL;
    const enum pel_status status = pel_gradient_init(&paint->base, ramp);
    if (status != PEL_OK)
        return status;
    if (!pel_point_legal(rings->center) || rings->radius < 256 ||
        rings->radius > PEL_PX(32767))
        return PEL_ERROR_RANGE;
    const uint32_t x = 128 - (uint32_t)rings->center.x;
    const uint32_t y = 128 - (uint32_t)rings->center.y;
    const int32_t n = paint->base.cells;
    paint->base.paint = (struct pel_paint){fill, NULL};
    paint->rings = *rings;
    paint->first = (int32_t)((uint32_t)rings->phase * (uint32_t)n >> 16);
    paint->width = (int32_t)pel_divide((uint32_t)rings->radius, (uint32_t)n);
    paint->rest = rings->radius - paint->width * n;
    paint->low = (x * x + y * y) & 511;
    return PEL_OK;
}
