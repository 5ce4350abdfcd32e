#include "outline.h"

#include "../raster/edge.h"
#include "outline_row.h"
#include "../raster/triangle_sort.h"

/* The two edges of the triangle that cross row y. */
struct sides {
    struct pel_edge a, b;
    int32_t y, bend, end; /* b is another edge from row bend on */
};

static void sides_start(struct sides *s, const struct pel_point *const v[3],
                        const struct pel_rect *clip)
{
    s->y = pel_max(pel_first_pixel(v[0]->y), clip->y0);
    s->end = pel_min(pel_first_pixel(v[2]->y), clip->y1);
    s->bend = pel_min(pel_first_pixel(v[1]->y), s->end);
    if (s->y < s->end)
        pel_edge_start(&s->a, v[0], v[2], s->y);
    if (s->y < s->bend)
        pel_edge_start(&s->b, v[0], v[1], s->y);
    else if (s->y < s->end)
        pel_edge_start(&s->b, v[1], v[2], s->y);
}

/* Sets the span of row y, not clipped, and moves on to the next. */
static PEL_NOINLINE_32 void sides_next(struct sides *s,
                                       const struct pel_point *const v[3],
                                       struct pel_span *span)
{
    span->x0 = pel_min(s->a.x, s->b.x);
    span->x1 = pel_max(s->a.x, s->b.x);
    s->y++;
    pel_edge_next(&s->a);
    if (s->y == s->bend && s->y < s->end)
        pel_edge_start(&s->b, v[1], v[2], s->y);
    else
        pel_edge_next(&s->b);
}

void pel_triangle_outline(const struct pel_surface *surface,
                          const struct pel_point v[3],
                          const struct pel_paint *paint)
{
    const struct pel_point *order[3] = {&v[0], &v[1], &v[2]};
    const struct pel_rect clip = pel_outline_clip(surface);
    struct sides s = {.y = 0};
    struct pel_outline_row o;
    PEL_ASSERT(pel_points_legal(v, 3));
    if (!pel_points_legal(v, 3) || pel_rect_empty(&surface->clip))
        return;
    const struct pel_rect box = pel_corners_box(v);
    const struct pel_rect seen = pel_rect_pixels(&box, &clip);
    if (pel_rect_empty(&seen))
        return;
    pel_sort_rows(order);
    sides_start(&s, order, &clip);
    pel_outline_begin(&o, surface);
    for (int32_t y = s.y; y <= s.end; y++) {
        *pel_outline_span(&o) = (struct pel_span){0, 0};
        if (y < s.end)
            sides_next(&s, order, pel_outline_span(&o));
        pel_outline_put(&o, paint, y);
    }
}
