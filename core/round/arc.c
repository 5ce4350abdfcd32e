#include "arc.h"

#include "ring_walk.h"
#include "wedge.h"

struct walk {
    struct pel_ring_walk ring;
    struct pel_wedge wedge;
    struct pel_cut cut;
};

/* Functions of their own, so that their stack is free again when a line is
 * painted. */
static PEL_WIDE bool start(struct walk *w, const struct pel_surface *surface,
                           const struct pel_arc_shape *arc)
{
    const struct pel_angles angles = {arc->from, arc->to};
    pel_cut_begin(&w->cut, surface);
    return pel_ring_start(&w->ring, &arc->center, arc->inner, arc->outer,
                          &surface->clip) &&
           pel_wedge_start(&w->wedge, &arc->center, angles, w->ring.outer.y);
}

/* The pieces of the next line. */
static PEL_WIDE void cut_line(struct walk *w, const struct pel_arc_shape *arc)
{
    const struct pel_rect *clip = &w->cut.spans.surface->clip;
    struct pel_span run, *span = w->cut.span;
    pel_wedge_parts(&w->wedge, &arc->center, w->ring.outer.y, span);
    pel_disc_row(&w->ring.outer.disc, clip, &run);
    w->cut.spans.n = pel_cut_within(span, 2, &run);
    pel_disc_row(&w->ring.hole, clip, &run);
    w->cut.spans.n = pel_cut_take(span, w->cut.spans.n, &run);
    pel_ring_next(&w->ring);
}

void pel_arc(const struct pel_surface *surface, const struct pel_arc_shape *arc,
             const struct pel_paint *paint)
{
    struct walk w;
    if (!start(&w, surface, arc))
        return;
    while (w.ring.outer.y < w.ring.outer.end) {
        cut_line(&w, arc);
        pel_cut_paint(&w.cut, paint, w.ring.outer.y - 1);
    }
}
