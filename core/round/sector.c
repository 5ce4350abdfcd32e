#include "sector.h"

#include "disc_walk.h"
#include "wedge.h"

void pel_sector(const struct pel_surface *surface,
                const struct pel_sector_shape *sector,
                const struct pel_paint *paint)
{
    struct pel_disc_walk w;
    struct pel_wedge wedge;
    if (!pel_disc_walk_start(&w, &sector->center, sector->radius,
                             &surface->clip) ||
        !pel_wedge_start(&wedge, &sector->center,
                         (struct pel_angles){sector->from, sector->to}, w.y))
        return;
    struct pel_span span[2];
    struct pel_spans spans = {surface, span, 0, 0, 0};
    for (; w.y < w.end; pel_disc_walk_next(&w)) {
        struct pel_span run;
        pel_wedge_parts(&wedge, &sector->center, w.y, span);
        pel_disc_row(&w.disc, &surface->clip, &run);
        spans.y = w.y;
        spans.n = pel_cut_within(span, 2, &run);
        if (spans.n)
            paint->fill(paint, &spans);
    }
}
