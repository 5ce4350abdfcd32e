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
 * `whole`, rest / n what the floor drops: k rings lie inside, `part` of them in
 * copy number `copy` of the way. */
struct side {
    struct pel_cells cells;
    union {
        struct {
            int32_t copy, part;
        } ring;         /* until the circle is set, */
        int64_t square; /* the circle's in 512ths, on the left side negative */
    } u;
};

/* To the next circle outwards, or inwards. */
static void circle_move(struct pel_cells *c, const struct pel_radial *p,
                        int32_t way)
{
    c->whole += way * p->width;
    c->rest += way * p->rest;
    if (c->rest < 0 || c->rest >= p->base.cells) {
        c->rest -= way * p->base.cells;
        c->whole += way;
    }
}

/* From the square of the circle before to that of this one. */
static PEL_NOINLINE_32 void set_square(struct side *s,
                                       const struct pel_radial *p)
{
    const int64_t mirror = s->cells.way >> 1; /* 0, or -1 */
    s->cells.end.error += s->u.square;
    s->u.square =
        (((pel_square(s->cells.whole) - p->low) >> 9) ^ mirror) - mirror;
    s->cells.end.error -= s->u.square;
}

static PEL_CELL_STEP bool end_cells(struct pel_cells *cells, int32_t count)
{
    const struct pel_radial *p = (const void *)cells->gradient;
    do
        circle_move(cells, p, cells->way);
    while (--count);
    set_square((void *)cells, p);
    const int32_t way = cells->way;
    const int32_t v = pel_pixel_center(cells->cell.y) - p->rings.center.y;
    return pel_cells_end(cells, way * (v + 128), way * 256);
}

static PEL_NOINLINE_32 int64_t square_at(const struct pel_radial *p, int32_t x,
                                         int32_t y)
{
    return pel_square(pel_pixel_center(x) - p->rings.center.x) +
           pel_square(pel_pixel_center(y) - p->rings.center.y);
}

/* The row of the pixel where the walk begins: the farthest from the centre on
 * the left side, the nearest on the right. */
static int32_t first_row(const struct pel_cells *c, const struct pel_radial *p)
{
    const int32_t y = c->cell.y, last = y + (c->cell.n - 1) * c->cell.step;
    if (PEL_CELL_ROWS == 1)
        return y;
    if (c->way > 0)
        return pel_min(pel_max(pel_pixel_of(p->rings.center.y), y), last);
    return 2 * p->rings.center.y - pel_pixel_center(y) > pel_pixel_center(last)
               ? y
               : last;
}

/* Of the square of a distance, below 2^51, in the error: its root, rounded up,
 * less 1, bit by bit. 0 of 0. */
static PEL_NOINLINE_32 void find_root(struct pel_cells *c)
{
    uint64_t root = 0, v = (uint64_t)c->end.error - (c->end.error > 0);
    for (uint64_t bit = UINT64_C(1) << 50; bit; bit >>= 2) {
        const uint64_t more = root + bit;
        root >>= 1;
        if (v >= more) {
            v -= more;
            root += bit;
        }
    }
    c->whole = (int32_t)root;
}

/* The ring that holds the pixel: ring k does when k radius / n < u, the root
 * rounded up, which is k <= (u n - 1) / radius. */
static PEL_NOINLINE_32 void find_ring(struct side *s,
                                      const struct pel_radial *p)
{
    const uint32_t radius = (uint32_t)p->rings.radius;
    const uint32_t below = (uint32_t)s->cells.whole;
    const uint32_t some = s->cells.end.error > 0;
    const uint32_t copy = pel_divide(below, radius);
    const uint64_t part =
        pel_multiply(below - copy * radius + some, (uint32_t)p->base.cells);
    s->u.ring.copy = (int32_t)copy;
    s->u.ring.part = (int32_t)pel_divide(part - some, radius);
}

/* The place of the ring that was found, and the circle where it begins: on the
 * left side the outer one, unless the last cell of a padded way begins farther
 * inside. */
static PEL_NOINLINE_32 void set_ring(struct side *s, const struct pel_radial *p)
{
    struct pel_cells *c = &s->cells;
    const int32_t n = p->base.cells, most = n - 1 - p->first;
    int32_t copy = s->u.ring.copy, part = s->u.ring.part;
    if (c->way < 0 && p->base.period == 0 && (copy || part > most)) {
        copy = 0;
        part = most;
    }
    if (c->way < 0)
        c->limit = copy < 65535 ? copy * n + part : INT32_MAX;
    const int32_t beyond = part > most;
    c->place = pel_gradient_place(&p->base, copy + beyond,
                                  part + p->first - beyond * n);
    const uint64_t ring =
        pel_multiply((uint32_t)part, (uint32_t)p->rings.radius);
    const uint32_t inner = pel_divide(ring, (uint32_t)n);
    c->whole = copy * p->rings.radius + (int32_t)inner;
    c->rest = (int32_t)((uint32_t)ring - inner * (uint32_t)n);
    if (c->way < 0)
        circle_move(c, p, 1);
}

/* From the square of the distance of the first pixel to its error. */
static PEL_NOINLINE_32 void set_end(struct side *s, const struct pel_radial *p)
{
    struct pel_boundary *end = &s->cells.end;
    const int32_t way = s->cells.way;
    end->step = way * (pel_pixel_center(end->x) - p->rings.center.x + 128);
    end->error = ((end->error >> 9) - 1) ^ (way >> 1);
    s->u.square = 0;
    set_square(s, p);
}

static PEL_ALWAYS_INLINE void start(struct side *s, const struct pel_radial *p)
{
    struct pel_cells *c = &s->cells;
    c->end.error = square_at(p, c->end.x, first_row(c, p));
    find_root(c);
    find_ring(s, p);
    set_ring(s, p);
    if (PEL_CELL_ROWS > 1)
        c->end.error = square_at(p, c->end.x, c->cell.y);
    set_end(s, p);
}

/* Rings narrower than 1/64 px are drawn a pixel at a time. */
static bool is_narrow(const struct pel_radial *p)
{
    return p->base.period && p->rings.radius < 4 * p->base.cells;
}

/* The part of the batch on one side. */
static PEL_CELL_STEP void set_side(struct pel_cells *c,
                                   const struct pel_radial *p)
{
    const int32_t split = pel_first_pixel(p->rings.center.x);
    if (is_narrow(p))
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
    while (pel_cells_next(&s.cells, is_narrow(p) ? 1 : PEL_CELL_ROWS)) {
        set_side(&s.cells, p);
        start(&s, p);
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
