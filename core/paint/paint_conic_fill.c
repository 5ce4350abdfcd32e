#include "../base/divide.h"
#include "../base/trig.h"
#include "cells.h"
#include "paint_conic.h"

enum { HALF_TURN = 32768, FULL_TURN = 65536 };

/* An angle between cells: floor(65536 k / period) from the start, and what the
 * floor drops. */
struct angle {
    uint32_t turn, rest;
};

/* Not before which angle, of 65,536, a pixel lies: bit by bit, since it is on
 * the ray of an angle of its half turn or clockwise of it where the cross
 * product is 0 or more. */
static uint32_t turn_of(int32_t u, int32_t v)
{
    uint32_t turn = v < 0 || (v == 0 && u < 0) ? HALF_TURN : 0;
    if (v == 0)
        return turn;
    for (uint32_t bit = HALF_TURN / 2; bit; bit >>= 1) {
        const struct pel_point d = pel_direction((uint16_t)(turn + bit));
        if (pel_product(d.x, v) - pel_product(d.y, u) >= 0)
            turn += bit;
    }
    return turn;
}

/* The last cell k that begins at or before a turn from the start:
 * 65536 k / period < turn + 1. (turn + 1) period <= 2^16 65,534. */
static int32_t place_of(const struct pel_conic *p, uint32_t turn)
{
    turn = (turn - p->start) & 0xFFFFu;
    return (int32_t)(((turn + 1) * (uint32_t)p->base.period - 1) >> 16);
}

static void angle_add(const struct pel_conic *p, struct angle *a)
{
    a->turn += p->width;
    a->rest += p->rest;
    if (a->rest >= (uint32_t)p->base.period) {
        a->rest -= (uint32_t)p->base.period;
        a->turn++;
    }
}

static void angle_take(const struct pel_conic *p, struct angle *a)
{
    a->turn -= p->width;
    if (a->rest < p->rest) {
        a->rest += (uint32_t)p->base.period;
        a->turn--;
    }
    a->rest -= p->rest;
}

/* Rows above or below the centre. */
struct rays {
    struct pel_cells cells;
    struct angle at; /* where the present cell begins */
};

/* The height of the first row, from the centre down. */
static int32_t height_of(const struct rays *r, const struct pel_conic *p)
{
    return pel_pixel_center(r->cells.cell.y) - p->center.y;
}

/* Ends at a ray d, which is not level. A pixel is on it or clockwise of it when
 * the cross product is 0 or more: beyond it above the centre, before it below.
 * The lowest 8 bits never change from pixel to pixel. */
static PEL_NOINLINE_32 bool end_at(struct rays *r, const struct pel_conic *p,
                                   struct pel_point d)
{
    struct pel_boundary *end = &r->cells.end;
    const int32_t u = pel_pixel_center(end->x) - p->center.x;
    const int64_t cross =
        (pel_product(d.x, height_of(r, p)) - pel_product(d.y, u)) >> 8;
    const bool above = d.y < 0;
    end->error = above ? cross : ~cross;
    end->step = above ? -d.y : d.y;
    return pel_cells_end(&r->cells, above ? d.x : -d.x, 0);
}

/* The next angle on the way. */
static void move(struct rays *r, const struct pel_conic *p)
{
    if (r->cells.way > 0)
        angle_add(p, &r->at);
    else
        angle_take(p, &r->at);
}

static PEL_CELL_STEP bool end_cells(struct pel_cells *cells, int32_t count)
{
    const struct pel_conic *p = (const void *)cells->gradient;
    struct rays *r = (void *)cells;
    do
        move(r, p);
    while (--count);
    return end_at(r, p, pel_direction((uint16_t)r->at.turn));
}

/* As many cells may end as begin in the half turn of the rows. The first pixel
 * by angle is in the first column: clockwise above the centre,
 * counter-clockwise below, in the row nearest to the centre where that is left
 * of it, else in the farthest one. */
static void rays_start(struct rays *r, const struct pel_conic *p, int32_t v)
{
    struct pel_cells *c = &r->cells;
    const int32_t u = pel_pixel_center(c->end.x) - p->center.x;
    const bool above = v < 0, last = above == (u < 0);
    if (last)
        v += (c->cell.n - 1) * c->cell.step * 256;
    c->place = place_of(p, turn_of(u, v));
    const uint32_t k = (uint32_t)c->place << 16;
    r->at.turn = pel_divide(k, (uint32_t)p->base.period);
    r->at.rest = k - r->at.turn * (uint32_t)p->base.period;
    r->at.turn += p->start;
    if (!above)
        angle_add(p, &r->at);
    c->way = above ? 1 : -1;
    c->limit = above ? place_of(p, FULL_TURN - 1) - c->place
                     : c->place - place_of(p, 0);
    if (c->limit < 0)
        c->limit += p->base.period;
}

/* The row through the centre has two angles: left of it a half turn, then 0. */
static void level_start(struct pel_cells *c, const struct pel_conic *p)
{
    const int32_t split = pel_first_pixel(p->center.x);
    const bool left = c->end.x < split;
    if (left)
        c->hi = pel_min(c->hi, split);
    c->limit = 0;
    c->place = place_of(p, left ? HALF_TURN : 0);
}

/* The batch has rows above the centre, or the row through it, or rows below. */
static PEL_NOINLINE_32 void start(struct rays *r, const struct pel_conic *p)
{
    struct pel_spans *rows = &r->cells.cell;
    const int32_t v = height_of(r, p);
    if (rows->step && v < 0)
        rows->n = pel_min(rows->n, pel_first_pixel(p->center.y) - rows->y);
    else if (rows->step && v == 0)
        rows->n = 1;
    if (v == 0)
        level_start(&r->cells, p);
    else
        rays_start(r, p, v);
}

static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    struct rays r;
    pel_cells_open(&r.cells, (const void *)paint, spans);
    while (pel_cells_next(&r.cells, spans, PEL_CELL_ROWS)) {
        start(&r, (const void *)paint);
        pel_cells_draw(&r.cells, end_cells);
    }
}

enum pel_status pel_conic_begin(struct pel_conic *paint,
                                struct pel_point center, uint16_t start)
{
    if (!pel_point_legal(center))
        return PEL_ERROR_RANGE;
    struct pel_gradient *g = &paint->base;
    if (g->period == 0)
        g->period = g->cells;
    const uint32_t n = (uint32_t)g->period, width = pel_divide(FULL_TURN, n);
    paint->width = (uint16_t)width;
    paint->rest = (uint16_t)(FULL_TURN - width * n);
    paint->center = center;
    paint->start = start;
    g->paint = (struct pel_paint){fill, NULL};
    return PEL_OK;
}
