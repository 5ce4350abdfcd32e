#include "outline.h"

#include "../round/disc.h"
#include "outline_row.h"

void pel_circle_outline(const struct pel_surface *surface,
                        struct pel_point center, int32_t radius,
                        const struct pel_paint *paint)
{
    const struct pel_rect clip = pel_outline_clip(surface);
    struct pel_disc_walk w;
    struct pel_outline_row o;
    if (pel_rect_empty(&surface->clip) ||
        !pel_disc_walk_box(&w, &center, radius, &clip))
        return;
    pel_disc_walk_begin(&w, &center, radius);
    pel_outline_begin(&o, surface);
    for (; w.visible.y0 <= w.visible.y1; pel_disc_walk_next(&w, &center)) {
        pel_outline_disc(&o, pel_disc_walk_ended(&w) ? NULL : &w.disc,
                         &w.visible);
        pel_outline_put(&o, paint, w.visible.y0);
    }
}
