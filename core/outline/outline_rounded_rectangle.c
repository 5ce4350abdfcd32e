#include "outline.h"

#include "outline_row.h"
#include "../round/rounded_rectangle_walk.h"

void pel_rounded_rectangle_outline(const struct pel_surface *surface,
                                   const struct pel_rounded_shape *r,
                                   const struct pel_paint *paint)
{
    const struct pel_rect clip = pel_outline_clip(surface);
    struct pel_rounded_walk w;
    struct pel_outline_row o;
    if (pel_rect_empty(&surface->clip) || !pel_rounded_start(&w, r, &clip))
        return;
    pel_outline_begin(&o, surface);
    for (; w.visible.y0 <= w.visible.y1; pel_rounded_next(&w)) {
        pel_outline_disc(&o, w.visible.y0 < w.visible.y1 ? &w.disc : NULL,
                         &w.visible);
        pel_outline_put(&o, paint, w.visible.y0);
    }
}
