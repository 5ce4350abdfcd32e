#include "outline.h"

#include "outline_line.h"

void pel_rectangle_outline(const struct pel_surface *surface,
                           struct pel_point from, struct pel_point to,
                           const struct pel_paint *paint)
{
    const struct pel_rect clip = pel_outline_clip(surface);
    const struct pel_span none = {0, 0};
    bool legal = pel_point_legal(from) && pel_point_legal(to);
    PEL_ASSERT(legal);
    struct pel_rect r = {pel_first_pixel(from.x), pel_first_pixel(from.y),
                         pel_first_pixel(to.x), pel_first_pixel(to.y)};
    r = pel_rect_intersect(&r, &clip);
    if (!legal || pel_rect_empty(&r) || pel_rect_empty(&surface->clip))
        return;
    struct pel_outline_line o;
    pel_outline_begin(&o, surface);
    const struct pel_span span = {r.x0, r.x1};
    for (int32_t y = r.y0; y <= r.y1; y++) {
        *pel_outline_run(&o) = y < r.y1 ? span : none;
        pel_outline_put(&o, paint, y);
    }
}
