#include "ring.h"

#include "../raster/cut.h"
#include "disc.h"

void pel_ring(const struct pel_surface *surface,
              const struct pel_ring_shape *ring, const struct pel_paint *paint)
{
    struct pel_ring_walk w;
    struct pel_span span[2];
    struct pel_spans spans = {surface, span, 0, 0, 0};
    if (!pel_ring_box(&w, &ring->center, ring->inner, ring->outer,
                      &surface->clip))
        return;
    pel_ring_begin(&w, &ring->center, ring->inner, ring->outer);
    for (; !pel_disc_walk_ended(&w.outer); pel_ring_next(&w, &ring->center)) {
        struct pel_span hole;
        pel_disc_walk_row(&w.outer, &span[0]);
        pel_ring_hole(&w, &hole);
        spans.y = w.outer.visible.y0;
        spans.n = pel_cut_hole(span, 0, &span[0], &hole);
        if (spans.n)
            paint->fill(paint, &spans);
    }
}
