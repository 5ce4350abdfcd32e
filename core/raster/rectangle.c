#include "rectangle.h"

#include "collect.h"

static void fill_rows(const struct pel_surface *surface,
                      const struct pel_rect *r, const struct pel_paint *paint)
{
    struct pel_row row[PEL_COLLECT_ROWS];
    struct pel_rows rows = {surface, row, r->y0, 0, 1};
    for (int i = 0; i < PEL_COLLECT_ROWS; i++)
        row[i] = (struct pel_row){r->x0, r->x1};
    for (; rows.y < r->y1; rows.y += rows.n) {
        rows.n = pel_min(r->y1 - rows.y, PEL_COLLECT_ROWS);
        paint->fill(paint, &rows);
    }
}

void pel_rectangle(const struct pel_surface *surface, struct pel_point from,
                   struct pel_point to, const struct pel_paint *paint)
{
    bool legal = pel_point_legal(from) && pel_point_legal(to);
    PEL_ASSERT(legal);
    if (!legal)
        return;
    struct pel_rect r = {pel_first_pixel(from.x), pel_first_pixel(from.y),
                         pel_first_pixel(to.x), pel_first_pixel(to.y)};
    r = pel_rect_intersect(&r, &surface->clip);
    if (!pel_rect_empty(&r))
        fill_rows(surface, &r, paint);
}

void pel_clear(const struct pel_surface *surface, pel_color color)
{
    const struct pel_flat flat = PEL_FLAT(color | PEL_RGB(0, 0, 0));
    if (!pel_rect_empty(&surface->clip))
        fill_rows(surface, &surface->clip, &flat.paint);
}
