#include "ring.h"

#include "../raster/cut.h"
#include "disc.h"

void pel_ring(const struct pel_surface *surface,
              const struct pel_ring_shape *ring, const struct pel_paint *paint)
{
    struct pel_ring_walk w;
    struct pel_span span[2];
    struct pel_spans spans = {surface, span, 0, 0, 0};
    if (!pel_ring_start(&w, &ring->center, ring->inner, ring->outer,
                        &surface->clip))
        return;
    for (; w.outer.y < w.outer.end; pel_ring_next(&w)) {
        struct pel_span hole;
        pel_disc_row(&w.outer.disc, &surface->clip, &span[0]);
        pel_disc_row(&w.hole, &surface->clip, &hole);
        spans.y = w.outer.y;
        spans.n = pel_cut_hole(span, 0, &span[0], &hole);
        if (spans.n)
            paint->fill(paint, &spans);
    }
}
