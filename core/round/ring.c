#include "ring.h"

#include "../raster/cut.h"
#include "ring_walk.h"

void pel_ring(const struct pel_surface *surface,
              const struct pel_ring_shape *ring, const struct pel_paint *paint)
{
    struct pel_ring_walk w;
    struct pel_row row[2];
    struct pel_rows rows = {surface, row, 0, 0, 0};
    if (!pel_ring_start(&w, &ring->center, ring->inner, ring->outer,
                        &surface->clip))
        return;
    for (; w.outer.y < w.outer.end; pel_ring_next(&w)) {
        struct pel_row hole;
        pel_disc_row(&w.outer.disc, &surface->clip, &row[0]);
        pel_disc_row(&w.hole, &surface->clip, &hole);
        rows.y = w.outer.y;
        rows.n = pel_cut_hole(row, 0, &row[0], &hole);
        if (rows.n)
            paint->fill(paint, &rows);
    }
}
