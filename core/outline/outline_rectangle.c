#include "outline.h"

#include "outline_row.h"

void pel_rectangle_outline(const struct pel_surface *surface,
                           struct pel_point from, struct pel_point to,
                           const struct pel_paint *paint)
{
    const struct pel_rect clip = pel_outline_clip(surface);
    const struct pel_span none = {0, 0};
    bool legal = pel_point_legal(from) && pel_point_legal(to);
    PEL_ASSERT(legal);
    if (!legal || pel_rect_empty(&surface->clip))
        return;
    const struct pel_rect box = {from.x, from.y, to.x, to.y};
    const struct pel_rect r = pel_rect_pixels(&box, &clip);
    if (pel_rect_empty(&r))
        return;
    struct pel_outline_row o;
    pel_outline_begin(&o, surface);
    const struct pel_span span = {r.x0, r.x1};
    for (int32_t y = r.y0; y <= r.y1; y++) {
        *pel_outline_span(&o) = y < r.y1 ? span : none;
        pel_outline_put(&o, paint, y);
    }
}
