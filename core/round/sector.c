#include "sector.h"

#include "angle_range.h"
#include "disc.h"

struct walk {
    struct pel_disc_walk circle;
    struct pel_angle_range angles;
    struct pel_cut cut;
};

/* Separate functions, so that their stack is free while a row is painted. */
static PEL_NOINLINE_32 bool start(struct walk *w,
                                  const struct pel_surface *surface,
                                  const struct pel_sector_shape *s)
{
    const struct pel_arc_shape arc = {s->center, 0, s->radius, s->from, s->to};
    pel_cut_begin(&w->cut, surface);
    if (!pel_disc_walk_box(&w->circle, &s->center, s->radius, &surface->clip) ||
        !pel_angle_range_start(&w->angles, &arc, &w->circle.visible, 0,
                               surface->clip.y0))
        return false;
    pel_disc_walk_begin(&w->circle, &s->center, s->radius);
    return true;
}

static PEL_NOINLINE_32 void cut_row(struct walk *w,
                                    const struct pel_sector_shape *sector)
{
    struct pel_span disc;
    pel_angle_range_spans(&w->angles, &sector->center, w->circle.visible.y0,
                          w->cut.span);
    pel_disc_walk_row(&w->circle, &disc);
    w->cut.spans.n = pel_cut_within(w->cut.span, 2, &disc);
}

void pel_sector(const struct pel_surface *surface,
                const struct pel_sector_shape *sector,
                const struct pel_paint *paint)
{
    struct walk w;
    if (!start(&w, surface, sector))
        return;
    for (; !pel_disc_walk_ended(&w.circle);
         pel_disc_walk_next(&w.circle, &sector->center)) {
        cut_row(&w, sector);
        pel_cut_paint(&w.cut, paint, w.circle.visible.y0);
    }
}
