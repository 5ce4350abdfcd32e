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
    return pel_ring_start(&w->ring, &arc->center, arc->inner, arc->outer,
                          &surface->clip) &&
           pel_angle_range_start(&w->angles, &arc->center, arc->from, arc->to,
                                 w->ring.outer.y);
}

/* Cuts the spans of a row and moves on to the next. */
static PEL_NOINLINE_32 void cut_row(struct walk *w,
                                    const struct pel_arc_shape *arc)
{
    const struct pel_rect *clip = &w->cut.spans.surface->clip;
    struct pel_span disc, *span = w->cut.span;
    pel_angle_range_spans(&w->angles, &arc->center, w->ring.outer.y, span);
    pel_disc_row(&w->ring.outer.disc, clip, &disc);
    w->cut.spans.n = pel_cut_within(span, 2, &disc);
    pel_disc_row(&w->ring.hole, clip, &disc);
    w->cut.spans.n = pel_cut_remove(span, w->cut.spans.n, &disc);
    pel_ring_next(&w->ring);
}

void pel_arc(const struct pel_surface *surface, const struct pel_arc_shape *arc,
             const struct pel_paint *paint)
{
    struct walk w;
    if (!start(&w, surface, arc))
        return;
    while (w.ring.outer.y < w.ring.outer.end) {
        cut_row(&w, arc);
        pel_cut_paint(&w.cut, paint, w.ring.outer.y - 1);
    }
}
