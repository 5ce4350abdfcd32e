#include "sector.h"

#include "disc_walk.h"
#include "wedge.h"

void pel_sector(const struct pel_surface *surface,
                const struct pel_sector_shape *sector,
                const struct pel_paint *paint)
{
    struct pel_disc_walk w;
    struct pel_wedge wedge;
    struct pel_cut cut;
    if (!pel_disc_walk_start(&w, &sector->center, sector->radius,
                             &surface->clip) ||
        !pel_wedge_start(&wedge, &sector->center, sector->from, sector->to))
        return;
    pel_cut_begin(&cut, surface, paint);
    for (; w.y < w.end; pel_disc_walk_next(&w)) {
        struct pel_row part[2], run;
        pel_wedge_parts(&wedge, w.y, part);
        pel_disc_row(&w.disc, &surface->clip, &run);
        pel_wedge_within(part, &run);
        for (int k = 0; k < 2; k++)
            pel_cut_piece(&cut, part[k].x0, part[k].x1);
        pel_cut_paint(&cut, w.y);
    }
}
