#include "sector.h"

#include "disc_walk.h"
#include "angle_range.h"

void pel_sector(const struct pel_surface *surface,
                const struct pel_sector_shape *sector,
                const struct pel_paint *paint)
{
    struct pel_disc_walk w;
    struct pel_angle_range angles;
    if (!pel_disc_walk_start(&w, &sector->center, sector->radius,
                             &surface->clip) ||
        !pel_angle_range_start(&angles, &sector->center, sector->from,
                               sector->to, w.y))
        return;
    struct pel_span span[2];
    struct pel_spans spans = {surface, span, 0, 0, 0};
    for (; w.y < w.end; pel_disc_walk_next(&w)) {
        struct pel_span disc;
        pel_angle_range_spans(&angles, &sector->center, w.y, span);
        pel_disc_row(&w.disc, &surface->clip, &disc);
        spans.y = w.y;
        spans.n = pel_cut_within(span, 2, &disc);
        if (spans.n)
            paint->fill(paint, &spans);
    }
}
