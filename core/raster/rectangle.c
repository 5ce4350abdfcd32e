#include "rectangle.h"

#include "collect.h"

/* More than other shapes where stack is short: a box takes little of it. */
enum { RECT_ROWS = PEL_SHORT_STACK ? PEL_BATCH_ROWS : PEL_COLLECT_ROWS };

/* All pixels of r, which is inside the clip when it is not empty. */
static PEL_ALWAYS_INLINE void fill_rows(const struct pel_surface *surface,
                                        const struct pel_rect *r,
                                        const struct pel_paint *paint)
{
    struct pel_span span[RECT_ROWS];
    struct pel_spans spans = {surface, span, r->y0, 0, 1};
    const int32_t end = r->y1;
    if (r->x0 >= r->x1 || (PEL_64BIT && r->y0 >= end))
        return;
    const int32_t used =
        PEL_64BIT ? pel_min(end - r->y0, RECT_ROWS) : RECT_ROWS;
    for (int32_t i = 0; i < used; i++)
        span[i] = (struct pel_span){r->x0, r->x1};
    for (int32_t y = r->y0; y < end; y += RECT_ROWS) {
        spans.y = y;
        spans.n = pel_min(end - y, RECT_ROWS);
        paint->fill(paint, &spans);
    }
}

void pel_box(const struct pel_surface *surface, const struct pel_rect *box,
             const struct pel_paint *paint)
{
    const struct pel_rect r = pel_rect_intersect(box, &surface->clip);
    fill_rows(surface, &r, paint);
}

void pel_rectangle(const struct pel_surface *surface, struct pel_point from,
                   struct pel_point to, const struct pel_paint *paint)
{
    const struct pel_rect box = {from.x, from.y, to.x, to.y};
    bool legal = pel_point_legal(from) && pel_point_legal(to);
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels((struct pel_point[2]){from, to}, 2, 0));
    if (!legal)
        return;
    const struct pel_rect r = pel_rect_pixels(&box, &surface->clip);
    fill_rows(surface, &r, paint);
}

/* The pixels of a surface that is visible as a whole and whose rows follow one
 * another without a gap; else 0, also where the product would not fit fill's
 * numbers of bits. */
static int32_t pixels_of_memory(const struct pel_surface *s)
{
    const bool pages = s->format->id == PEL_FORMAT_MONO1_PAGES;
    const int32_t width = s->bounds.x1 - s->bounds.x0;
    const int32_t height = s->bounds.y1 - s->bounds.y0;
    const int32_t bits = pages ? width * 8 : width * s->format->bits;
    if (!pel_rect_inside(&s->bounds, &s->clip) || (bits & 7) ||
        s->stride != bits >> 3 || (width | height) >> 13 ||
        (pages && (height & 7)))
        return 0;
    return width * height;
}

/* Fills of core take such memory as one row. */
void pel_clear(const struct pel_surface *surface, pel_color color)
{
    const struct pel_flat flat = PEL_FLAT(color | PEL_RGB(0, 0, 0));
    const struct pel_format *format = surface->format;
    const struct pel_rect *clip = &surface->clip;
    if (pel_rect_empty(clip))
        return;
    const int32_t n =
        format->id < 128 && format->fill ? pixels_of_memory(surface) : 0;
    const struct pel_span row = {clip->x0, clip->x0 + n};
    const struct pel_spans rows = {surface, &row, clip->y0, 1, 0};
    if (n)
        format->fill(&rows, format->pack(color));
    else
        fill_rows(surface, clip, &flat.paint);
}
