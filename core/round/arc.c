#include "arc.h"

#include "angle_range.h"
#include "disc.h"

struct walk {
    struct pel_ring_walk ring;
    struct pel_angle_range angles;
    struct pel_cut cut;
};

/* Separate functions, so that their stack is free while a row is painted. */
static PEL_NOINLINE_32 bool start(struct walk *w,
                                  const struct pel_surface *surface,
                                  const struct pel_arc_shape *arc)
{
    pel_cut_begin(&w->cut, surface);
    if (!pel_ring_box(&w->ring, &arc->center, arc->inner, arc->outer,
                      &surface->clip) ||
        !pel_angle_range_start(&w->angles, arc, &w->ring.outer.visible, 0,
                               surface->clip.y0))
        return false;
    pel_ring_begin(&w->ring, &arc->center, arc->inner, arc->outer);
    return true;
}

/* Cuts the spans of a row and moves on to the next. */
static PEL_NOINLINE_32 void cut_row(struct walk *w,
                                    const struct pel_arc_shape *arc)
{
    const struct pel_rect *visible = &w->ring.outer.visible;
    struct pel_span disc, *span = w->cut.span;
    pel_angle_range_spans(&w->angles, &arc->center, visible->y0, span);
    pel_disc_walk_row(&w->ring.outer, &disc);
    w->cut.spans.n = pel_cut_within(span, 2, &disc);
    pel_ring_hole(&w->ring, &disc);
    w->cut.spans.n = pel_cut_remove(span, w->cut.spans.n, &disc);
    pel_ring_next(&w->ring, &arc->center);
}

void pel_arc(const struct pel_surface *surface, const struct pel_arc_shape *arc,
             const struct pel_paint *paint)
{
    struct walk w;
    if (!start(&w, surface, arc))
        return;
    while (!pel_disc_walk_ended(&w.ring.outer)) {
        cut_row(&w, arc);
        pel_cut_paint(&w.cut, paint, w.ring.outer.visible.y0 - 1);
    }
}
