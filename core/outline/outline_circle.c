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
        !pel_disc_walk_start(&w, &center, radius, &clip))
        return;
    pel_outline_begin(&o, surface);
    for (; w.y <= w.end; pel_disc_walk_next(&w)) {
        pel_outline_disc(&o, w.y < w.end ? &w.disc : NULL, &clip);
        pel_outline_put(&o, paint, w.y);
    }
}
