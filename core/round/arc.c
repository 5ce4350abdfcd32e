#include "arc.h"

#include "ring_walk.h"
#include "wedge.h"

void pel_arc(const struct pel_surface *surface, const struct pel_arc_shape *arc,
             const struct pel_paint *paint)
{
    const struct pel_ring_shape ring = {arc->center, arc->inner, arc->outer};
    struct pel_ring_walk w;
    struct pel_wedge wedge;
    struct pel_cut cut;
    if (!pel_ring_start(&w, &ring, &surface->clip) ||
        !pel_wedge_start(&wedge, arc->center, arc->from, arc->to,
                         &surface->clip))
        return;
    pel_cut_begin(&cut, surface, paint);
    for (; w.outer.y < w.outer.end; pel_ring_next(&w)) {
        struct pel_row run = pel_disc_row(&w.outer.disc);
        struct pel_row hole = pel_disc_row(&w.hole);
        pel_wedge_cut(&wedge, &cut, w.outer.y, run, hole);
        pel_cut_paint(&cut, w.outer.y);
    }
}
