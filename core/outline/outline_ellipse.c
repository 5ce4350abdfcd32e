#include "outline.h"

#include "../round/ellipse_walk.h"
#include "outline_row.h"

void pel_ellipse_outline(const struct pel_surface *surface,
                         const struct pel_ellipse_shape *ellipse,
                         const struct pel_paint *paint)
{
    const struct pel_rect clip = pel_outline_clip(surface);
    struct pel_ellipse_walk w;
    struct pel_outline_row o;
    if (pel_rect_empty(&surface->clip) ||
        !pel_ellipse_start(&w, ellipse, &clip))
        return;
    pel_outline_begin(&o, surface);
    for (; w.y <= w.end; pel_ellipse_next(&w, ellipse)) {
        pel_outline_disc(&o, w.y < w.end ? &w.disc : NULL, &clip);
        pel_outline_put(&o, paint, w.y);
    }
}
