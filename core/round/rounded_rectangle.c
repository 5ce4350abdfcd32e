#include "rounded_rectangle.h"

#include "../raster/collect.h"
#include "rounded_rectangle_walk.h"

void pel_rounded_rectangle(const struct pel_surface *surface,
                           const struct pel_rounded_shape *rectangle,
                           const struct pel_paint *paint)
{
    struct pel_rounded_walk w;
    struct pel_collector c;
    if (!pel_rounded_start(&w, rectangle, &surface->clip))
        return;
    pel_collect_begin(&c, surface, paint);
    for (; w.visible.y0 < w.visible.y1; pel_rounded_next(&w)) {
        struct pel_span span;
        pel_disc_row(&w.disc, &w.visible, &span);
        if (span.x0 < span.x1)
            pel_collect(&c, w.visible.y0, span.x0, span.x1);
    }
    pel_collect_end(&c);
}
