#include "ellipse.h"

#include "../raster/collect.h"
#include "ellipse_walk.h"

void pel_ellipse(const struct pel_surface *surface,
                 const struct pel_ellipse_shape *ellipse,
                 const struct pel_paint *paint)
{
    struct pel_ellipse_walk w;
    struct pel_collector c;
    if (!pel_ellipse_start(&w, ellipse, &surface->clip))
        return;
    pel_collect_begin(&c, surface, paint);
    for (; w.y < w.end; pel_ellipse_next(&w, ellipse)) {
        struct pel_span span;
        pel_disc_row(&w.disc, &surface->clip, &span);
        if (span.x0 < span.x1)
            pel_collect(&c, w.y, span.x0, span.x1);
    }
    pel_collect_end(&c);
}
