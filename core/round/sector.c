#include "sector.h"

#include "disc_walk.h"
#include "wedge.h"

void pel_sector(const struct pel_surface *surface,
                const struct pel_sector_shape *sector,
                const struct pel_paint *paint)
{
    const struct pel_row none = {0, 0};
    struct pel_disc_walk w;
    struct pel_wedge wedge;
    struct pel_cut cut;
    if (!pel_disc_walk_start(&w, sector->center, sector->radius,
                             &surface->clip) ||
        !pel_wedge_start(&wedge, sector->center, sector->from, sector->to,
                         &surface->clip))
        return;
    pel_cut_begin(&cut, surface, paint);
    for (; w.y < w.end; pel_disc_walk_next(&w)) {
        pel_wedge_cut(&wedge, &cut, w.y, pel_disc_row(&w.disc), none);
        pel_cut_paint(&cut, w.y);
    }
}
