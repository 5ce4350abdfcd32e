#include "../base/divide.h"
#include "../base/trig.h"
#include "cells.h"
#include "paint_conic.h"

enum { HALF_TURN = 32768, FULL_TURN = 65536 };

/* The last cell k that begins at or before a turn from the start:
 * 65536 k / period < turn + 1. (turn + 1) period <= 2^16 65,534. */
static int32_t place_of(const struct pel_conic *p, uint32_t turn)
{
    turn = (turn - p->start) & 0xFFFFu;
    return (int32_t)(((turn + 1) * (uint32_t)p->base.period - 1) >> 16);
}

/* The height of the first row, from the centre down. */
static int32_t height_of(const struct pel_cells *c)
{
    const struct pel_conic *p = (const void *)c->gradient;
    return pel_pixel_center(c->cell.y) - p->center.y;
}

/* The cross product of a ray and the pixel at end.x, at a height: 0 or more
 * when the pixel lies on the ray or clockwise of it. */
static PEL_NOINLINE_32 int64_t cross_of(const struct pel_cells *c, int32_t dx,
                                        int32_t dy, int32_t height)
{
    const struct pel_conic *p = (const void *)c->gradient;
    const int32_t u = pel_pixel_center(c->end.x) - p->center.x;
    return pel_product(dx, height) - pel_product(dy, u);
}

/* Adds to c->whole up to the last angle that is not past the pixel in the first
 * column, at the height in c->rest: bit by bit from c->limit. */
static PEL_ALWAYS_INLINE void find_angle(struct pel_cells *c)
{
    for (; c->limit; c->limit >>= 1) {
        const struct pel_point d =
            pel_direction((uint16_t)(c->whole + c->limit));
        if (cross_of(c, d.x, d.y, c->rest) >= 0)
            c->whole += c->limit;
    }
}

/* Moves by `count` >= 1 cells. The present one begins at the angle floor(65536
 * k / period) from the start, c->whole, and c->rest is what the floor drops. */
static PEL_NOINLINE_32 void angle_move(struct pel_cells *c, int32_t count)
{
    const struct pel_conic *p = (const void *)c->gradient;
    const int32_t way = c->way;
    do {
        c->whole += way * p->width;
        c->rest += way * p->rest;
        if ((uint32_t)c->rest >= (uint32_t)p->base.period) {
            c->rest -= way * p->base.period;
            c->whole += way;
        }
    } while (--count);
}

/* Ends at a ray d, which is not level. On it or clockwise of it is beyond it
 * above the centre, before it below. The lowest 8 bits of the cross product
 * never change from pixel to pixel. */
static PEL_NOINLINE_32 bool end_at(struct pel_cells *c, struct pel_point d)
{
    struct pel_boundary *end = &c->end;
    const int64_t cross = cross_of(c, d.x, d.y, height_of(c)) >> 8;
    const bool above = d.y < 0;
    end->error = above ? cross : ~cross;
    end->step = above ? -d.y : d.y;
    return pel_cells_end(c, above ? d.x : -d.x, 0);
}

static PEL_CELL_STEP bool end_cells(struct pel_cells *cells, int32_t count)
{
    angle_move(cells, count);
    return end_at(cells, pel_direction((uint16_t)cells->whole));
}

/* Cuts the batch, so that it has rows above the centre, or the row through it,
 * which has two angles, or rows below. Finds the height of the first pixel by
 * angle, and its half turn: it is in the first column, clockwise above the
 * centre, counter-clockwise below, in the row nearest to the centre where that
 * is left of it, else in the farthest one. */
static PEL_NOINLINE_32 void first_row(struct pel_cells *c)
{
    const struct pel_conic *p = (const void *)c->gradient;
    const int32_t v = height_of(c);
    const int32_t split = pel_first_pixel(p->center.x);
    const bool above = v < 0, left = c->end.x < split;
    if (PEL_CELL_ROWS > 1 && c->cell.step && v <= 0)
        c->cell.n = pel_min(
            c->cell.n, above ? pel_first_pixel(p->center.y) - c->cell.y : 1);
    if (v == 0 && left)
        c->hi = pel_min(c->hi, split);
    c->way = above ? 1 : -1;
    c->whole = above || (v == 0 && left) ? HALF_TURN : 0;
    c->limit = v ? HALF_TURN / 2 : 0;
    c->rest = v;
    if (PEL_CELL_ROWS > 1 && v && above == left)
        c->rest += (c->cell.n - 1) * c->cell.step * 256;
}

/* The cell of the angle. As many may end as begin in the half turn of the rows,
 * and none in the row through the centre. */
static PEL_NOINLINE_32 void set_cell(struct pel_cells *c)
{
    const struct pel_conic *p = (const void *)c->gradient;
    const bool above = c->way > 0, level = c->rest == 0;
    c->place = place_of(p, (uint32_t)c->whole);
    const uint32_t k = (uint32_t)(c->place + !above) << 16;
    const uint32_t turn = pel_divide(k, (uint32_t)p->base.period);
    c->rest = (int32_t)(k - turn * (uint32_t)p->base.period);
    c->whole = (int32_t)(turn + p->start);
    c->limit = c->way * (place_of(p, above ? UINT32_MAX : 0) - c->place);
    if (c->limit < 0)
        c->limit += p->base.period;
    if (level)
        c->limit = 0;
}

static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    struct pel_cells c;
    pel_cells_open(&c, (const void *)paint, spans);
    while (pel_cells_next(&c, PEL_CELL_ROWS)) {
        first_row(&c);
        find_angle(&c);
        set_cell(&c);
        pel_cells_draw(&c, end_cells);
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
