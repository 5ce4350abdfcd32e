#include "../base/fixed.h"
#include "ramp_mix.h"
#include "ramp_walk.h"

#if !PEL_FAST_64BIT

/* The walk's position in 2^-32 of the way, as the spread shows it. */
static uint32_t position(const struct pel_ramp_walk *w, enum pel_spread spread)
{
    if (spread == PEL_REFLECT) {
        /* The highest bit tells which way: a full turn is there and back. */
        uint32_t twice = (uint32_t)(w->at >> (w->bits - 31));
        return (twice ^ (0 - (twice >> 31))) << 1;
    }
    if (spread == PEL_PAD && !w->inside && w->at >> w->bits)
        return w->at >> 63 ? 0 : UINT32_MAX;
    return (uint32_t)(w->at >> (w->bits - 32));
}

static pel_color color_at(const struct pel_ramp *ramp, uint32_t at)
{
    if (ramp->n != 2)
        return ramp->colors[pel_ramp_cell(at, (uint32_t)ramp->n)];
    const pel_color a = ramp->colors[0], b = ramp->colors[1];
    return pel_pair_at(pel_pair_of(a, b), at >> 24) |
           pel_pair_at(pel_pair_of(a >> 8, b >> 8), at >> 24) << 8;
}

void pel_ramp_run(const struct pel_ramp *ramp, struct pel_ramp_walk *walk,
                  int32_t n, pel_color *colors)
{
    for (; n > 0; n--, pel_ramp_step(walk))
        *colors++ = color_at(ramp, position(walk, ramp->spread));
}

static PEL_NOINLINE void put_some(const struct pel_walker *walker,
                                  const struct pel_surface *surface,
                                  const struct pel_run *run,
                                  struct pel_ramp_walk *walk)
{
    pel_color colors[PEL_BUFFER_PIXELS];
    walker->run(walker->paint, walk, run->n, colors);
    pel_put_colors(surface, run->x, run->y, run->n, colors);
}

/* A walk goes on from one buffer to the next: only its beginning is costly. */
void pel_walker_fill(const struct pel_walker *walker,
                     const struct pel_rows *rows)
{
    struct pel_ramp_walk walk;
    struct pel_run run;
    run.y = rows->y;
    for (int32_t i = 0; i < rows->n; i++, run.y += rows->step) {
        int32_t left = 0;
        for (run.x = rows->row[i].x0; run.x < rows->row[i].x1; run.x += run.n) {
            run.n = rows->row[i].x1 - run.x;
            if (left == 0)
                left = walker->begin(walker->paint, &run, &walk);
            run.n = pel_min(left, PEL_BUFFER_PIXELS);
            put_some(walker, rows->surface, &run, &walk);
            left -= run.n;
        }
    }
}

void pel_walker_colors(const struct pel_walker *walker, struct pel_run run,
                       pel_color *colors)
{
    struct pel_ramp_walk walk;
    for (int32_t part; run.n > 0; run.n -= part, run.x += part) {
        part = walker->begin(walker->paint, &run, &walk);
        walker->run(walker->paint, &walk, part, colors);
        colors += part;
    }
}

#endif
