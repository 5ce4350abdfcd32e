#include "paint_radial.h"

#include "../base/divide.h"
#include "../base/sqrt.h"
#include "../raster/edge.h"
#include "../round/disc_side.h"
#include "cells.h"

/* A circle between rings: k of them lie inside, in copy number `copy` of the
 * way. Its radius is floor(k radius / n) exactly, rest / n what the floor
 * drops. */
struct circle {
    int32_t copy, part;
    int32_t radius, rest;
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

static int32_t place_of(const struct pel_radial *p, const struct circle *c)
{
    int32_t copy = c->copy, part = c->part + p->first;
    if (part >= p->base.cells) {
        part -= p->base.cells;
        copy++;
    }
    return pel_gradient_place(&p->base, copy, part);
}

/* One side of the rings, left or right of the centre. A circle's columns are
 * counted from there, or from where rows begin; `steps` is the square of the
 * distance of the next one outwards in 512ths, as disc.h has it. */
struct side {
    struct pel_cells cells;
    struct circle circle; /* where the present cell ends */
    int64_t steps;        /* these three at the first row and the last circle;
                             first the square of a pixel's distance */
    int32_t u, columns;
    int32_t first; /* the column that is 0 */
    int32_t limit; /* so many columns are visible */
};

/* The height of the first row, from the centre down. */
static int32_t height_of(const struct side *s, const struct pel_radial *p)
{
    return pel_pixel_center(s->cells.cell.y) - p->rings.center.y;
}

static void circle_outwards(const struct pel_radial *p, struct circle *c)
{
    c->radius += p->width;
    c->rest += p->rest;
    if (c->rest >= p->base.cells) {
        c->rest -= p->base.cells;
        c->radius++;
    }
}

static void circle_inwards(const struct pel_radial *p, struct circle *c)
{
    c->radius -= p->width;
    c->rest -= p->rest;
    if (c->rest < 0) {
        c->rest += p->base.cells;
        c->radius--;
    }
}

static void circle_move(struct side *s, int32_t count)
{
    const struct pel_radial *p = (const void *)s->cells.gradient;
    for (; count > 0; count--)
        if (s->cells.step < 0)
            circle_inwards(p, &s->circle);
        else
            circle_outwards(p, &s->circle);
}

/* Columns grow to the left on the left side, where the walk is inwards. */
static PEL_CELL_STEP bool end_cells(struct pel_cells *cells, int32_t count)
{
    const struct pel_radial *p = (const void *)cells->gradient;
    struct side *s = (void *)cells;
    circle_move(s, count - 1);
    int64_t d = -s->steps;
    s->steps = (pel_square(s->circle.radius) - p->low) >> 9;
    d += s->steps;
    int32_t u = s->u, columns = s->columns, rest = 0;
    int32_t v = height_of(s, p) + 128;
    for (int32_t i = 0; i < cells->cell.n; i++) {
        pel_disc_side_adjust(&d, &u, &columns, s->limit);
        if (i == 0) {
            s->steps -= d;
            s->u = u;
            s->columns = columns;
        }
        rest |= pel_cells_end_run(cells, i, s->first + columns * cells->step);
        if (cells->cell.step) {
            d -= v;
            v += 256;
        }
    }
    circle_move(s, 1);
    return rest < 0;
}

/* Behind the last pixel of all rows before `stop`. */
static int32_t end_of(const struct pel_cells *c)
{
    int32_t x1 = c->span[0].x1;
    for (int32_t i = 1; i < c->cell.n; i++)
        x1 = pel_max(x1, c->span[i].x1);
    return pel_min(x1, c->stop);
}

/* The columns before the first of the right side, or the rest. */
static PEL_NOINLINE_32 void set_columns(struct side *s,
                                        const struct pel_radial *p, int32_t x0)
{
    struct pel_cells *c = &s->cells;
    const int32_t split = pel_first_pixel(p->rings.center.x);
    s->columns = 0;
    s->first = x0;
    if (x0 < split) {
        c->step = -1;
        c->stop = pel_min(c->stop, split);
        s->first = end_of(c);
        s->limit = s->first - x0;
        s->u = p->rings.center.x - pel_pixel_center(s->first - 1);
    } else {
        s->limit = end_of(c) - x0;
        s->u = pel_pixel_center(x0) - p->rings.center.x;
    }
}

/* The square of the distance of the pixel where the walk begins: the farthest
 * one on the left side, the nearest one on the right. */
static PEL_NOINLINE_32 void set_square(struct side *s,
                                       const struct pel_radial *p, int32_t x0)
{
    const struct pel_spans *rows = &s->cells.cell;
    const int32_t last = rows->y + (rows->n - 1) * rows->step;
    const int32_t middle = pel_pixel_of(p->rings.center.y);
    const int32_t twice = 2 * p->rings.center.y;
    int32_t y = pel_min(pel_max(middle, rows->y), last);
    if (s->cells.step < 0)
        y = twice - pel_pixel_center(rows->y) > pel_pixel_center(last) ? rows->y
                                                                       : last;
    const int32_t u = pel_pixel_center(x0) - p->rings.center.x;
    const int32_t v = pel_pixel_center(y) - p->rings.center.y;
    s->steps = pel_square(u) + pel_square(v);
}

/* The inner circle of the ring that holds the pixel where the walk begins, the
 * square of its distance being below 2^49. With u its root, rounded up, ring k
 * holds it when k radius / n < u, which is k <= (u n - 1) / radius. */
static PEL_NOINLINE_32 void find_ring(struct side *s,
                                      const struct pel_radial *p)
{
    const uint64_t square = (uint64_t)s->steps;
    const uint32_t radius = (uint32_t)p->rings.radius;
    const uint32_t n = (uint32_t)p->base.cells;
    struct pel_root root;
    pel_square_root(square, &root);
    if (pel_multiply(root.root, root.root) == square && root.root)
        root.root--; /* u - 1 */
    const uint32_t copy = pel_divide(root.root, radius);
    const uint32_t part =
        pel_divide(pel_multiply(root.root - copy * radius + (square > 0), n) -
                       (square > 0),
                   radius);
    circle_set(p, (int32_t)copy, (int32_t)part, &s->circle);
}

/* From the circle that was found: the ring's inner one, which is the end of the
 * first cell on the left side. */
static PEL_NOINLINE_32 void set_ring(struct side *s, const struct pel_radial *p)
{
    struct pel_cells *c = &s->cells;
    struct circle *circle = &s->circle;
    const int32_t n = p->base.cells, most = n - 1 - p->first;
    if (c->step < 0) {
        if (p->base.period == 0 && (circle->copy || circle->part > most))
            circle_set(p, 0, most, circle);
        c->limit =
            circle->copy < 65535 ? circle->copy * n + circle->part : INT32_MAX;
    }
    c->place = place_of(p, circle);
    if (c->step > 0)
        circle_outwards(p, circle);
    s->steps = (pel_square(s->u) + pel_square(height_of(s, p))) >> 9;
}

/* A function of its own, to spare the stack of what comes before it. */
static PEL_NOINLINE_32 void walk(struct side *s)
{
    pel_cells_draw(&s->cells, end_cells);
}

/* The first pixel of the next batch. Rings narrower than 1/64 px are drawn a
 * pixel at a time. */
static PEL_CELL_STEP int32_t next(struct side *s, const struct pel_radial *p,
                                  const struct pel_spans *spans)
{
    const bool by_pixel = p->base.period && p->rings.radius < 4 * p->base.cells;
    const int32_t x0 =
        pel_cells_next(&s->cells, spans, by_pixel ? 1 : PEL_CELL_ROWS);
    if (by_pixel && x0 < INT32_MAX)
        s->cells.stop = x0 + 1;
    return x0;
}

static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    const struct pel_radial *p = (const void *)paint;
    struct side s;
    pel_cells_open(&s.cells, &p->base, spans);
    for (int32_t x0; (x0 = next(&s, p, spans)) < INT32_MAX;) {
        set_columns(&s, p, x0);
        set_square(&s, p, x0);
        find_ring(&s, p);
        set_ring(&s, p);
        walk(&s);
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
    paint->width = pel_floor_divide(rings->radius, n, &paint->rest);
    paint->low = (x * x + y * y) & 511;
    return PEL_OK;
}
