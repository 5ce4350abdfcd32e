#include "sector.h"

#include "angle_range.h"
#include "disc.h"

struct walk {
    struct pel_disc_walk circle;
    struct pel_angle_range angles;
    struct pel_cut cut;
};

/* A function of its own, so that its stack is free while a row is painted. */
static PEL_NOINLINE_32 void cut_row(struct walk *w,
                                    const struct pel_sector_shape *sector)
{
    const struct pel_rect *clip = &w->cut.spans.surface->clip;
    struct pel_span disc;
    pel_angle_range_spans(&w->angles, &sector->center, w->circle.y,
                          w->cut.span);
    pel_disc_row(&w->circle.disc, clip, &disc);
    w->cut.spans.n = pel_cut_within(w->cut.span, 2, &disc);
}

void pel_sector(const struct pel_surface *surface,
                const struct pel_sector_shape *sector,
                const struct pel_paint *paint)
{
    struct walk w;
    pel_cut_begin(&w.cut, surface);
    if (!pel_disc_walk_start(&w.circle, &sector->center, sector->radius,
                             &surface->clip) ||
        !pel_angle_range_start(&w.angles, &sector->center, sector->from,
                               sector->to, w.circle.y))
        return;
    for (; w.circle.y < w.circle.end; pel_disc_walk_next(&w.circle)) {
        cut_row(&w, sector);
        pel_cut_paint(&w.cut, paint, w.circle.y);
    }
}
