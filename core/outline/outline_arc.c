#include "outline.h"

#include "../round/disc_walk.h"
#include "outline_line.h"
#include "../round/wedge.h"

void pel_arc_outline(const struct pel_surface *surface,
                     const struct pel_sector_shape *sector,
                     const struct pel_paint *paint)
{
    const struct pel_rect clip = pel_outline_clip(surface);
    struct pel_disc_walk w;
    struct pel_wedge wedge;
    struct pel_outline_line o;
    if (pel_rect_empty(&surface->clip) ||
        !pel_disc_walk_start(&w, &sector->center, sector->radius, &clip) ||
        !pel_wedge_start(&wedge, &sector->center, sector->from, sector->to))
        return;
    pel_outline_begin(&o, surface, paint);
    for (; w.y <= w.end; pel_disc_walk_next(&w)) {
        struct pel_row part[2], run = {0, 0}, inside;
        if (w.y < w.end)
            pel_disc_row(&w.disc, &clip, &run);
        if (!pel_outline_next(&o, w.y, &run, &inside))
            continue;
        pel_wedge_parts(&wedge, w.y - 1, part);
        pel_wedge_within(part, &run);
        for (int k = 0; k < 2; k++)
            pel_cut_hole(&o.cut, &part[k], &inside);
        pel_cut_paint(&o.cut, w.y - 1);
    }
}
