#include "ring.h"

#include "../raster/collect.h"
#include "ring_walk.h"

static void collect(struct pel_collector *c, int32_t y, int32_t x0, int32_t x1)
{
    if (x0 < x1)
        pel_collect(c, y, x0, x1);
}

void pel_ring(const struct pel_surface *surface,
              const struct pel_ring_shape *ring, const struct pel_paint *paint)
{
    struct pel_ring_walk w;
    struct pel_collector c;
    if (!pel_ring_start(&w, &ring->center, ring->inner, ring->outer,
                        &surface->clip))
        return;
    pel_collect_begin(&c, surface, paint);
    for (; w.outer.y < w.outer.end; pel_ring_next(&w)) {
        struct pel_row run, hole;
        pel_disc_row(&w.outer.disc, &surface->clip, &run);
        pel_disc_row(&w.hole, &surface->clip, &hole);
        if (hole.x0 >= hole.x1)
            hole.x0 = hole.x1 = run.x1;
        collect(&c, w.outer.y, run.x0, pel_min(run.x1, hole.x0));
        collect(&c, w.outer.y, pel_max(run.x0, hole.x1), run.x1);
    }
    pel_collect_end(&c);
}
