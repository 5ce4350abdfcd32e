#include "outline.h"

#include "../round/ellipse_walk.h"
#include "outline_row.h"

/* Separate functions, so that their stack is free while a row is painted. */
static PEL_NOINLINE_32 bool start(struct pel_ellipse_walk *w,
                                  const struct pel_surface *surface,
                                  const struct pel_ellipse_shape *ellipse)
{
    const struct pel_rect clip = pel_outline_clip(surface);
    return !pel_rect_empty(&surface->clip) &&
           pel_ellipse_start(w, ellipse, &clip);
}

static PEL_NOINLINE_32 void set_row(struct pel_outline_row *o,
                                    struct pel_ellipse_walk *w)
{
    const struct pel_rect clip = pel_outline_clip(o->cut.spans.surface);
    pel_outline_disc(o, w->y < w->end ? &w->disc : NULL, &clip);
}

void pel_ellipse_outline(const struct pel_surface *surface,
                         const struct pel_ellipse_shape *ellipse,
                         const struct pel_paint *paint)
{
    struct pel_ellipse_walk w;
    struct pel_outline_row o;
    if (!start(&w, surface, ellipse))
        return;
    pel_outline_begin(&o, surface);
    for (; w.y <= w.end; pel_ellipse_next(&w, ellipse)) {
        set_row(&o, &w);
        pel_outline_put(&o, paint, w.y);
    }
}
