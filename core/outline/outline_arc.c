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
                                  const struct pel_sector_shape *s)
{
    if (pel_rect_empty(&surface->clip))
        return false;
    struct pel_rect *const visible = &w->circle.visible;
    const struct pel_arc_shape arc = {s->center, 0, s->radius, s->from, s->to};
    pel_outline_begin(&w->row, surface);
    *visible = pel_outline_clip(surface);
    if (!pel_disc_walk_box(&w->circle, &s->center, s->radius, visible) ||
        !pel_angle_range_start(&w->angles, &arc, visible, 1, surface->clip.y0))
        return false;
    pel_disc_walk_begin(&w->circle, &s->center, s->radius);
    return true;
}

/* Cuts the spans of the row above the next row of the circle. */
static PEL_NOINLINE_32 void cut_row(struct walk *w,
                                    const struct pel_sector_shape *sector)
{
    struct pel_outline_row *o = &w->row;
    const int32_t y = w->circle.visible.y0;
    struct pel_span inside, disc, *span = pel_outline_span(o);
    *span = (struct pel_span){0, 0};
    if (!pel_disc_walk_ended(&w->circle))
        pel_disc_walk_row(&w->circle, span);
    if (pel_outline_next(o, y, &inside)) {
        disc = *span;
        pel_angle_range_spans(&w->angles, &sector->center, y - 1, span);
        o->cut.spans.n = pel_cut_within(span, 2, &disc);
        o->cut.spans.n = pel_cut_remove(span, o->cut.spans.n, &inside);
    }
    pel_disc_walk_next(&w->circle, &sector->center);
}

void pel_arc_outline(const struct pel_surface *surface,
                     const struct pel_sector_shape *sector,
                     const struct pel_paint *paint)
{
    struct walk w;
    if (!start(&w, surface, sector))
        return;
    while (w.circle.visible.y0 <= w.circle.visible.y1) {
        cut_row(&w, sector);
        pel_cut_paint(&w.row.cut, paint, w.circle.visible.y0 - 2);
    }
}
