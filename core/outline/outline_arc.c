#include "outline.h"

#include "../round/disc.h"
#include "../round/angle_range.h"
#include "outline_row.h"

struct walk {
    struct pel_disc_walk circle;
    struct pel_angle_range angles;
    struct pel_outline_row row;
};

/* Separate functions, so that their stack is free while a row is painted. */
static PEL_NOINLINE_32 bool start(struct walk *w,
                                  const struct pel_surface *surface,
                                  const struct pel_sector_shape *sector)
{
    if (pel_rect_empty(&surface->clip))
        return false;
    const struct pel_rect clip = pel_outline_clip(surface);
    pel_outline_begin(&w->row, surface);
    return pel_disc_walk_start(&w->circle, &sector->center, sector->radius,
                               &clip) &&
           pel_angle_range_start(&w->angles, &sector->center, sector->from,
                                 sector->to,
                                 pel_max(w->circle.y - 1, surface->clip.y0));
}

/* Cuts the spans of the row above the next row of the circle. */
static PEL_NOINLINE_32 void cut_row(struct walk *w,
                                    const struct pel_sector_shape *sector)
{
    struct pel_outline_row *o = &w->row;
    const struct pel_rect clip = pel_outline_clip(o->cut.spans.surface);
    struct pel_span inside, disc, *span = pel_outline_span(o);
    *span = (struct pel_span){0, 0};
    if (w->circle.y < w->circle.end)
        pel_disc_row(&w->circle.disc, &clip, span);
    if (pel_outline_next(o, w->circle.y, &inside)) {
        disc = *span;
        pel_angle_range_spans(&w->angles, &sector->center, w->circle.y - 1,
                              span);
        o->cut.spans.n = pel_cut_within(span, 2, &disc);
        o->cut.spans.n = pel_cut_remove(span, o->cut.spans.n, &inside);
    }
    pel_disc_walk_next(&w->circle);
}

void pel_arc_outline(const struct pel_surface *surface,
                     const struct pel_sector_shape *sector,
                     const struct pel_paint *paint)
{
    struct walk w;
    if (!start(&w, surface, sector))
        return;
    while (w.circle.y <= w.circle.end) {
        cut_row(&w, sector);
        pel_cut_paint(&w.row.cut, paint, w.circle.y - 2);
    }
}
