#include "rounded_rectangle.h"

#include "../raster/collect.h"
#include "rounded_rectangle_walk.h"

/* half_width2 (disc.h) of the corners in row y; v, the distance of the row
 * above or below their centres, is at most the radius. */
static int64_t half_width2_at(const struct pel_rounded_walk *w, int32_t y)
{
    int32_t center = pel_pixel_center(y), v = 0;
    if (center < w->top)
        v = w->top - center;
    else if (center > w->bottom)
        v = center - w->bottom;
    return pel_square(w->radius) - pel_square(v);
}

bool pel_rounded_start(struct pel_rounded_walk *w,
                       const struct pel_rounded_shape *r,
                       const struct pel_rect *clip)
{
    const struct pel_point from = r->from, to = r->to;
    bool legal = pel_point_legal(from) && pel_point_legal(to) &&
                 pel_radius_legal(r->radius);
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels((struct pel_point[2]){from, to}, 2, r->radius));
    if (!legal)
        return false;
    const struct pel_rect box = {from.x, from.y, to.x, to.y};
    w->visible = pel_rect_pixels(&box, clip);
    if (pel_rect_empty(&w->visible))
        return false;
    int32_t side = pel_min(to.x - from.x, to.y - from.y);
    w->radius = pel_min(r->radius, side / 2);
    w->top = from.y + w->radius;
    w->bottom = to.y - w->radius;
    w->half_width2 = half_width2_at(w, w->visible.y0);
    pel_disc_center(&w->disc, from.x + w->radius, to.x - w->radius);
    pel_disc_start(&w->disc, &w->visible, w->half_width2);
    return true;
}

bool pel_rounded_next(struct pel_rounded_walk *w)
{
    const int64_t half_width2 = half_width2_at(w, ++w->visible.y0);
    if (half_width2 == w->half_width2)
        return false;
    pel_disc_change(&w->disc, w->half_width2, half_width2);
    w->half_width2 = half_width2;
    return true;
}

void pel_rounded_rectangle(const struct pel_surface *surface,
                           const struct pel_rounded_shape *rectangle,
                           const struct pel_paint *paint)
{
    struct pel_rounded_walk w;
    struct pel_collector c;
    if (!pel_rounded_start(&w, rectangle, &surface->clip))
        return;
    struct pel_span span = {0, 0};
    bool other = true;
    pel_collect_begin(&c, surface, paint);
    for (; w.visible.y0 < w.visible.y1; other = pel_rounded_next(&w)) {
        if (other)
            pel_disc_row(&w.disc, &w.visible, &span);
        if (span.x0 < span.x1)
            pel_collect(&c, w.visible.y0, span.x0, span.x1);
    }
    pel_collect_end(&c);
}
