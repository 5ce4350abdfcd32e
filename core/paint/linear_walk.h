/* Runs of a linear gradient whose cells are a few pixels wide, and all seen, as
 * under a dither: the format walks through them itself. */
#ifndef PEL_PAINT_LINEAR_WALK_H
#define PEL_PAINT_LINEAR_WALK_H

#include "cells.h"
#include "paint_linear.h"

/* From the cell at a place on: how many cells of the same copy of the ramp come
 * after it. */
static inline int32_t pel_walk_color(struct pel_walk *walk,
                                     const struct pel_linear *p, int32_t place)
{
    const struct pel_gradient *const g = &p->base;
    const struct pel_mix mix = pel_mix_of(g->ramp.colors[0], g->ramp.colors[1]);
    const bool back = place >= g->cells, down = back == (p->way > 0);
    const int32_t i = back ? g->period - 1 - place : place;
    const uint32_t sign = down ? UINT32_MAX : 1;
    walk->high = mix.high + mix.high_change * (uint32_t)i;
    walk->low = mix.low + mix.low_change * (uint32_t)i;
    walk->high_change = sign * mix.high_change;
    walk->low_change = sign * mix.low_change;
    return down ? i : g->cells - 1 - i;
}

/* The pixels x to x1 - 1 before the way or behind it. */
static inline void pel_walk_pad(const struct pel_cells *c,
                                const struct pel_walk *walk, int32_t x,
                                int32_t x1)
{
    const struct pel_span pad = {x, x1};
    const struct pel_spans one = {c->cell.surface, &pad, c->cell.y, 1, 0};
    if (x < x1)
        pel_fill_color(&one, pel_mixed(walk->high, walk->low));
}

/* The pixels c->x to x1 - 1, from the cell at c->place on, which begins where
 * c->error is 0. False: the format does not walk. */
static inline bool pel_walk_run(const struct pel_cells *c,
                                const struct pel_linear *p, int32_t x1)
{
    const struct pel_surface *const s = c->cell.surface;
    struct pel_walk walk = {.rest = c->rest,
                            .cell = (int32_t)p->cell,
                            .cell_rest = p->cell_rest,
                            .unit = p->base.cells * 256,
                            .step = p->d.x};
    int64_t error = c->error;
    int32_t x = c->x, place = c->place, n;
    walk.left = pel_walk_color(&walk, p, place);
    for (; error < 0 && x < x1; x++)
        error += p->d.x;
    pel_walk_pad(c, &walk, c->x, x);
    walk.error = (int32_t)error;
    for (; x < x1; x += n) {
        const int32_t last = place + p->way * walk.left;
        n = s->format->channels->walk(s, x, c->cell.y, x1 - x, &walk);
        if (n == 0)
            return false;
        place = pel_cells_after(&p->base, last, p->way);
        walk.left = pel_walk_color(&walk, p, place);
        if (place == last) {
            pel_walk_pad(c, &walk, x + n, x1);
            break;
        }
    }
    return true;
}

#endif
