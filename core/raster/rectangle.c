#include "rectangle.h"

#include "collect.h"

void pel_box(const struct pel_surface *surface, const struct pel_rect *box,
             const struct pel_paint *paint)
{
    const struct pel_rect r = pel_rect_intersect(box, &surface->clip);
    struct pel_span span[PEL_COLLECT_ROWS];
    struct pel_spans spans = {surface, span, r.y0, 0, 1};
    if (pel_rect_empty(&r))
        return;
    for (int i = 0; i < PEL_COLLECT_ROWS; i++)
        span[i] = (struct pel_span){r.x0, r.x1};
    for (; spans.y < r.y1; spans.y += spans.n) {
        spans.n = pel_min(r.y1 - spans.y, PEL_COLLECT_ROWS);
        paint->fill(paint, &spans);
    }
}

void pel_rectangle(const struct pel_surface *surface, struct pel_point from,
                   struct pel_point to, const struct pel_paint *paint)
{
    bool legal = pel_point_legal(from) && pel_point_legal(to);
    PEL_ASSERT(legal);
    if (!legal)
        return;
    const struct pel_rect r = {pel_first_pixel(from.x), pel_first_pixel(from.y),
                               pel_first_pixel(to.x), pel_first_pixel(to.y)};
    pel_box(surface, &r, paint);
}

void pel_clear(const struct pel_surface *surface, pel_color color)
{
    const struct pel_flat flat = PEL_FLAT(color | PEL_RGB(0, 0, 0));
    pel_box(surface, &surface->clip, &flat.paint);
}
