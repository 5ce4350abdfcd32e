#include "../base/divide.h"
#include "../base/trig.h"
#include "cells_fill.h"
#include "paint_conic.h"

enum { HALF_TURN = 32768, FULL_TURN = 65536, HUES = 6 * 256 };

/* The height of the first row, from the centre down. */
static int32_t height_of(const struct pel_cells *c)
{
    const struct pel_conic *p = (const void *)c->gradient;
    return pel_pixel_center(c->cell.y) - p->center.y;
}

/* The cross product of a ray and the pixel at x, at a height: 0 or more when
 * the pixel lies on the ray or clockwise of it. */
static PEL_NOINLINE_32 int64_t cross_of(const struct pel_cells *c,
                                        const struct pel_point *ray,
                                        int32_t height)
{
    const struct pel_conic *p = (const void *)c->gradient;
    const int32_t u = pel_pixel_center(c->at.x1) - p->center.x;
    return pel_product(ray->x, height) - pel_product(ray->y, u);
}

/* Adds to c->whole up to the last angle that is not past the pixel in the first
 * column, at the height in c->value: bit by bit. */
static PEL_ALWAYS_INLINE void find_angle(struct pel_cells *c)
{
    for (int32_t bit = HALF_TURN / 2; bit && c->direction; bit >>= 1) {
        const struct pel_point d = pel_direction((uint16_t)(c->whole + bit));
        if (cross_of(c, &d, (int32_t)c->value) >= 0)
            c->whole += bit;
    }
}

/* The present cell begins at the angle floor(65536 k / period) from the start,
 * c->whole, and c->remainder is what the floor drops. Rows above the centre end
 * before the full turn, rows below at 0. On a ray or clockwise of it is beyond
 * it above the centre, before it below. The lowest 8 bits of the cross product
 * never change from pixel to pixel. */
static PEL_STEP_OR_INLINE void set_error(struct pel_cells *c,
                                         const struct pel_point *ray)
{
    const int64_t cross = cross_of(c, ray, height_of(c)) >> 8;
    c->error = c->direction < 0 ? ~cross : cross;
}

static PEL_STEP_OR_INLINE bool move_angle(struct pel_cells *c, int32_t count)
{
    const struct pel_conic *p = (const void *)c->gradient;
    pel_cells_move(c, count, p->width, p->remainder, p->base.period);
    return (uint32_t)(c->whole - 1) >> 16;
}

static PEL_HOT bool end_cells(struct pel_cells *c, int32_t count)
{
    if (move_angle(c, count))
        return pel_cells_end_all(c);
    const struct pel_point d = pel_direction((uint16_t)c->whole);
    set_error(c, &d);
    return pel_cells_end(c, pel_magnitude(d.y), c->direction * d.x, 0);
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
    const bool above = v < 0, left = c->at.x1 < split;
    if (PEL_CELL_ROWS > 1 && c->cell.step && v <= 0)
        c->cell.n = pel_min(
            c->cell.n, above ? pel_first_pixel(p->center.y) - c->cell.y : 1);
    c->direction = (pel_cell_direction)((v < 0) - (v > 0));
    c->whole = above ? HALF_TURN : 0;
    if (v == 0 && left) {
        c->whole = HALF_TURN;
        c->hi = pel_min(c->hi, split);
    }
    int32_t height = v;
    if (PEL_CELL_ROWS > 1 && v && above == left)
        height += (c->cell.n - 1) * c->cell.step * 256;
    c->value = (uint32_t)height;
}

/* The cell of the angle: the last k that begins at or before `turn` from the
 * start, 65536 k / period < turn + 1. (turn + 1) period <= 2^16 65,534. */
static PEL_NOINLINE_32 void set_cell(struct pel_cells *c)
{
    const struct pel_conic *p = (const void *)c->gradient;
    const uint32_t period = (uint32_t)p->base.period;
    const uint32_t turn = ((uint32_t)c->whole - p->start) & 0xFFFFu;
    uint32_t k = ((turn + 1) * period - 1) >> 16;
    c->index = (pel_cell_index)k;
    k = (k + (c->direction < 0)) << 16;
    const uint32_t begin = pel_divide(k, period);
    c->whole += (int32_t)(begin - turn);
    c->remainder = (pel_cell_rest)(k - begin * period);
}

static PEL_ALWAYS_INLINE void start(struct pel_cells *c)
{
    first_row(c);
    find_angle(c);
    set_cell(c);
}

static PEL_STEP_OR_INLINE void fill_rows(const struct pel_paint *paint,
                                         const struct pel_spans *spans,
                                         int32_t most, struct pel_span *run)
{
    struct pel_cells c;
    pel_cells_begin(&c, paint, spans, most, run);
    pel_cells_fill(&c, spans, start, end_cells);
}

static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    if (PEL_SHORT_STACK)
        pel_cells_fill_apart(paint, spans, PEL_CELL_ROWS, fill_rows);
    else
        fill_rows(paint, spans, PEL_CELL_ROWS, NULL);
}

static enum pel_status begin(struct pel_conic *paint, struct pel_point center,
                             uint16_t start)
{
    if (!pel_point_legal(center))
        return PEL_ERROR_RANGE;
    struct pel_gradient *g = &paint->base;
    const uint32_t n = (uint32_t)g->period, width = pel_divide(FULL_TURN, n);
    paint->width = (int32_t)width;
    paint->remainder = (int32_t)(FULL_TURN - width * n);
    paint->center = center;
    paint->start = start;
    g->ramp.spread = PEL_REPEAT;
    g->paint.fill = fill;
    return PEL_OK;
}

enum pel_status pel_conic_init(struct pel_conic *paint, struct pel_point center,
                               uint16_t start, const struct pel_ramp *ramp)
{
    const enum pel_status status = pel_gradient_init((void *)paint, ramp);
    return status == PEL_OK ? begin(paint, center, start) : status;
}

static pel_color hue_color(const struct pel_gradient *gradient, int32_t cell)
{
    const struct pel_hue_wheel *p = (const void *)gradient;
    return pel_hsv_sixth((uint32_t)cell >> 8, ((uint32_t)cell & 255) * 2 + 1,
                         512, p->s, p->v);
}

enum pel_status pel_hue_wheel_init(struct pel_hue_wheel *paint,
                                   struct pel_point center, uint16_t start,
                                   uint8_t s, uint8_t v)
{
    static const struct pel_gradient hues = {
        {pel_nothing_fill, NULL}, hue_color, {NULL, 0, PEL_REPEAT}, HUES, HUES};
    if (!paint)
        return PEL_ERROR_NULL;
    paint->conic.base = hues;
    paint->s = s;
    paint->v = v;
    return begin(&paint->conic, center, start);
}
