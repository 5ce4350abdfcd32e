#include "outline.h"

#include "../round/disc_walk.h"
#include "../round/wedge.h"
#include "outline_line.h"

struct walk {
    struct pel_disc_walk circle;
    struct pel_wedge wedge;
    struct pel_outline_line line;
    struct pel_rect clip;
};

/* Functions of their own, so that their stack is free again when a line is
 * painted. */
static PEL_WIDE bool start(struct walk *w, const struct pel_surface *surface,
                           const struct pel_sector_shape *sector)
{
    const struct pel_angles angles = {sector->from, sector->to};
    if (pel_rect_empty(&surface->clip))
        return false;
    w->clip = pel_outline_clip(surface);
    pel_outline_begin(&w->line, surface);
    return pel_disc_walk_start(&w->circle, &sector->center, sector->radius,
                               &w->clip) &&
           pel_wedge_start(&w->wedge, &sector->center, angles,
                           pel_max(w->circle.y - 1, surface->clip.y0));
}

/* The pieces of the line above the circle's next one. */
static PEL_WIDE void cut_line(struct walk *w,
                              const struct pel_sector_shape *sector)
{
    struct pel_outline_line *o = &w->line;
    struct pel_span inside, run, *span = pel_outline_run(o);
    *span = (struct pel_span){0, 0};
    if (w->circle.y < w->circle.end)
        pel_disc_row(&w->circle.disc, &w->clip, span);
    if (pel_outline_next(o, w->circle.y, &inside)) {
        run = *span;
        pel_wedge_parts(&w->wedge, &sector->center, w->circle.y - 1, span);
        o->cut.spans.n = pel_cut_within(span, 2, &run);
        o->cut.spans.n = pel_cut_take(span, o->cut.spans.n, &inside);
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
        cut_line(&w, sector);
        pel_cut_paint(&w.line.cut, paint, w.circle.y - 2);
    }
}
