#include "paint_radial.h"

#include "../base/divide.h"
#include "../raster/edge.h"
#include "cells_fill.h"

/* Rings narrower than so many 1/256 px are not walked over one by one. */
enum { NARROW = 256 / PEL_CELL_ROWS };

/* One side of the rings, left or right of the centre. Squares of distances are
 * counted in 512ths: from pixel to pixel and from row to row they grow by whole
 * ones, so that what is left of them, p->low, never changes. A pixel lies
 * beyond a circle on the right side when the square of its distance is larger
 * than that of the radius, on the left side when it is not.
 *
 * The present cell begins at a circle of the radius floor(k radius / n), cells'
 * `whole`, remainder / n what the floor drops: k rings lie inside. */

int64_t pel_radial_square(const struct pel_radial *p, int32_t x, int32_t y)
{
    return pel_square(pel_pixel_center(x) - p->rings.center.x) +
           pel_square(pel_pixel_center(y) - p->rings.center.y);
}

/* Adds the square of the present circle's radius, in 512ths, to the error, or
 * takes it away. No circles lie inside the centre. */
static PEL_NOINLINE_32 void add_circle(struct pel_cells *c,
                                       const struct pel_radial *p,
                                       int32_t direction)
{
    const int64_t square = (pel_square(pel_max(c->whole, 0)) - p->low) >> 9;
    c->error += direction < 0 ? -square : square;
}

static PEL_STEP_OR_INLINE void move_circle(struct pel_cells *c,
                                           const struct pel_radial *p,
                                           int32_t count)
{
    add_circle(c, p, c->direction);
    pel_cells_move(c, count, p->width, p->remainder, p->base.cells);
    add_circle(c, p, -c->direction);
}

static PEL_HOT bool end_cells(struct pel_cells *c, int32_t count)
{
    const struct pel_radial *p = (const void *)c->gradient;
    move_circle(c, p, count);
    const struct pel_point center = p->rings.center;
    const int32_t direction = c->direction;
    return pel_cells_end(
        c, direction * (pel_pixel_center(c->at.x1) - center.x + 128),
        direction * (pel_pixel_center(c->cell.y) - center.y + 128),
        direction * 256);
}

/* The row of the pixel where the walk begins: the farthest from the centre on
 * the left side, the nearest on the right. */
static int32_t first_row(const struct pel_cells *c, int32_t center)
{
    const int32_t y = c->cell.y, end = y + (c->cell.n - 1) * c->cell.step + 1;
    if (PEL_CELL_ROWS == 1)
        return y;
    return c->direction > 0 ? pel_nearest_pixel(y, end, center)
                            : pel_farthest_pixel(y, end, center);
}

/* The root of the square of a distance, below 2^51, rounded up, less 1, bit by
 * bit. 0 of 0. */
static PEL_NOINLINE_32 int32_t root_of(int64_t square)
{
    int32_t root = 0;
    for (int32_t bit = 1 << 25; bit; bit >>= 1)
        if (pel_square(root + bit) < square)
            root += bit;
    return root;
}

static int32_t quotient(int64_t n, int32_t d)
{
    return (int32_t)pel_divide((uint64_t)n, (uint32_t)d);
}

/* The ring that holds the pixel, its index, and the circle where it begins. It
 * is the largest k with k radius / n < u, the root rounded up, which is k <=
 * (u n - 1) / radius. On the left side rings begin at the outer circle, unless
 * the last cell of a padded ramp begins farther inside. */
static PEL_NOINLINE_32 void find_ring(struct pel_cells *c,
                                      const struct pel_radial *p)
{
    const int32_t radius = p->rings.radius, n = p->base.cells;
    const int32_t most = n - 1 - p->first, some = c->error != 0;
    int32_t copy = quotient(c->whole, radius);
    int32_t part = quotient(
        pel_product(c->whole - copy * radius + some, n) - some, radius);
    if (c->direction < 0 && p->base.ramp.spread == PEL_PAD &&
        (copy || part > most)) {
        copy = 0;
        part = most;
    }
    const bool beyond = part > most;
    c->index = (pel_cell_index)pel_cells_index(
        &p->base, copy + beyond, part + p->first - (beyond ? n : 0));
    const int64_t ring = pel_product(part + (c->direction < 0), radius);
    const int32_t begin = quotient(ring, n);
    c->whole = copy * radius + begin;
    c->remainder =
        (pel_cell_rest)((uint32_t)ring - (uint32_t)begin * (uint32_t)n);
}

/* Chooses the part of the batch on one side, and measures the square of the
 * distance of the pixel where the walk begins. */
static PEL_STEP_OR_INLINE void start_side(struct pel_cells *c,
                                          const struct pel_radial *p)
{
    const int32_t split = pel_first_pixel(p->rings.center.x);
    c->direction = 1;
    if (c->at.x1 < split) {
        c->direction = -1;
        c->hi = pel_min(c->hi, split);
    }
    c->error = pel_radial_square(p, c->at.x1, first_row(c, p->rings.center.y));
}

static PEL_STEP_OR_INLINE void start_error(struct pel_cells *c,
                                           const struct pel_radial *p)
{
    c->error = (pel_radial_square(p, c->at.x1, c->cell.y) >> 9) - 1;
    if (c->direction < 0)
        c->error = ~c->error;
    add_circle(c, p, -c->direction);
}

static PEL_ALWAYS_INLINE void start(struct pel_cells *c)
{
    const struct pel_radial *p = (const void *)c->gradient;
    start_side(c, p);
    c->whole = root_of(c->error);
    find_ring(c, p);
    start_error(c, p);
}

/* A walk along a row from pixel to pixel, over many rings: the largest whole
 * number below the distance, from 0 on, and by how much the square of the
 * distance is larger than its square, up to 2 root + 1. The ring, below the
 * period where it begins anew, and what is left of the division that finds
 * it. */
struct row_walk {
    const struct pel_radial *paint;
    int32_t u; /* of the pixel, from the centre */
    int32_t over, root, remainder;
    uint32_t ring;
};

static PEL_NOINLINE_32 void row_walk_start(void *walk, int32_t x, int32_t y)
{
    struct row_walk *w = walk;
    const struct pel_radial *p = w->paint;
    const uint32_t radius = (uint32_t)p->rings.radius;
    const int64_t square = pel_radial_square(p, x, y);
    const int32_t root = root_of(square);
    w->root = root;
    w->over = (int32_t)(square - pel_square(root));
    w->u = pel_pixel_center(x) - p->rings.center.x;
    const int64_t parts = pel_product(root + 1, p->base.cells) - 1;
    w->ring = pel_divide((uint64_t)parts, radius);
    w->remainder = (int32_t)((uint32_t)parts - w->ring * radius);
    w->ring += (uint32_t)p->first;
    if (p->base.ramp.spread != PEL_PAD)
        w->ring %= (uint32_t)p->base.period;
}

/* The root of the next pixel. It is larger by about 256 u / root: that is at
 * most 256 wrong near the centre, and 3 where roots are large, so what is over
 * is below 2^29 and fits, modulo 2^32. */
static PEL_NOINLINE_32 int32_t next_root(struct row_walk *w)
{
    const int32_t u = w->u, next = w->root + 1, far = next >> 22 ? 8 : 0;
    int32_t remainder, root = w->root;
    root += pel_floor_divide(u * (256 >> far), next >> far, &remainder);
    root = pel_max(root, 0);
    uint32_t over = (uint32_t)w->over + 512 * (uint32_t)u + 65536 +
                    (uint32_t)(w->root - root) * (uint32_t)(w->root + root);
    for (; (int32_t)over <= 0 && root > 0; root--)
        over += 2 * (uint32_t)root - 1;
    for (; (int32_t)over > 2 * root + 1; root++)
        over -= 2 * (uint32_t)root + 1;
    w->u = u + 256;
    w->over = (int32_t)over;
    return root;
}

/* |root - w->root| n <= 2^23: a ramp and a ring at most. */
static void row_walk_next(struct row_walk *w)
{
    const struct pel_radial *p = w->paint;
    const int32_t root = next_root(w);
    w->ring += (uint32_t)pel_floor_divide(w->remainder +
                                              (root - w->root) * p->base.cells,
                                          p->rings.radius, &w->remainder);
    w->root = root;
    const uint32_t period = (uint32_t)p->base.period;
    if (p->base.ramp.spread != PEL_PAD)
        while (w->ring >= period)
            w->ring += (int32_t)w->ring < 0 ? period : 0 - period;
}

static PEL_NOINLINE_32 void row_walk_colors(void *walk, int32_t n,
                                            pel_color *out)
{
    struct row_walk *w = walk;
    const struct pel_gradient *const g = &w->paint->base;
    for (; n > 0; n--, row_walk_next(w)) {
        const uint32_t last = (uint32_t)g->period - 1;
        const uint32_t ring = w->over ? w->ring : (uint32_t)w->paint->first;
        *out++ = g->color(g, (int32_t)(ring < last ? ring : last));
    }
}

static PEL_NOINLINE_32 void fill_pixels(const struct pel_radial *p,
                                        const struct pel_spans *spans)
{
    struct row_walk w = {p, 0, 0, 0, 0, 0};
    pel_cells_put(spans, &w, row_walk_start, row_walk_colors);
}

static PEL_STEP_OR_INLINE void fill_rows(const struct pel_paint *paint,
                                         const struct pel_spans *spans,
                                         int32_t most, struct pel_span *run)
{
    struct pel_cells c;
    pel_cells_begin(&c, paint, spans, most, run);
    pel_cells_fill(&c, spans, start, end_cells);
}

/* Of rings so narrow that a pixel has many of them. */
static PEL_STEP_OR_INLINE bool is_narrow(const struct pel_radial *p,
                                         const struct pel_spans *spans)
{
    return PEL_CELL_ROWS > 1 && p->rings.radius < NARROW * p->base.cells &&
           pel_cells_are_many(&p->base, spans);
}

static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    const struct pel_radial *p = (const void *)paint;
    const bool narrow = is_narrow(p, spans);
    if (PEL_FAST_FILLS && PEL_64BIT && pel_radial_fast(p, spans))
        return;
    if (narrow && spans->surface->format->put)
        fill_pixels(p, spans);
    else if (PEL_SHORT_STACK)
        pel_cells_fill_apart(paint, spans, narrow ? 0 : PEL_CELL_ROWS,
                             fill_rows);
    else
        fill_rows(paint, spans, narrow ? 0 : PEL_CELL_ROWS, NULL);
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
    paint->remainder = rings->radius - paint->width * n;
    paint->low = (uint32_t)pel_radial_square(paint, 0, 0) & 511;
    return PEL_OK;
}
