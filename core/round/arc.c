#include "arc.h"

#include "ring_walk.h"
#include "wedge.h"

void pel_arc(const struct pel_surface *surface, const struct pel_arc_shape *arc,
             const struct pel_paint *paint)
{
    struct pel_ring_walk w;
    struct pel_wedge wedge;
    struct pel_cut cut;
    if (!pel_ring_start(&w, &arc->center, arc->inner, arc->outer,
                        &surface->clip) ||
        !pel_wedge_start(&wedge, &arc->center, arc->from, arc->to))
        return;
    pel_cut_begin(&cut, surface, paint);
    for (; w.outer.y < w.outer.end; pel_ring_next(&w)) {
        struct pel_row part[2], run;
        pel_wedge_parts(&wedge, w.outer.y, part);
        pel_disc_row(&w.outer.disc, &surface->clip, &run);
        pel_wedge_within(part, &run);
        pel_disc_row(&w.hole, &surface->clip, &run);
        for (int k = 0; k < 2; k++)
            pel_cut_hole(&cut, &part[k], &run);
        pel_cut_paint(&cut, w.outer.y);
    }
}
