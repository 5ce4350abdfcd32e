/* Spans of one row, cut by holes and angles, for a paint. On the stack it is
 * smaller than a batch of rows (collect.h). */
#ifndef PEL_RASTER_CUT_H
#define PEL_RASTER_CUT_H

#include "paint.h"

/* Two disjoint spans without one hole: the hole can split one of them. */
enum { PEL_CUT_SPANS = 3 };

struct pel_cut {
    struct pel_spans spans;
    struct pel_span span[PEL_CUT_SPANS];
};

static inline void pel_cut_begin(struct pel_cut *c,
                                 const struct pel_surface *surface)
{
    c->spans = (struct pel_spans){surface, c->span, 0, 0, 0};
}

/* Stores [x0, x1), if not empty, as span n; returns the number of spans. */
static inline int32_t pel_cut_add(struct pel_span *span, int32_t n, int32_t x0,
                                  int32_t x1)
{
    if (x0 >= x1)
        return n;
    span[n] = (struct pel_span){x0, x1};
    return n + 1;
}

/* Cuts n spans to `bounds`, in place; returns how many are left. */
static inline int32_t pel_cut_within(struct pel_span *span, int32_t n,
                                     const struct pel_span *bounds)
{
    int32_t count = 0;
    for (int32_t k = 0; k < n; k++)
        count = pel_cut_add(span, count, pel_max(bounds->x0, span[k].x0),
                            pel_min(bounds->x1, span[k].x1));
    return count;
}

/* Stores `whole` without `hole` as span n and perhaps n + 1; an empty hole cuts
 * nothing. Returns the number of spans. */
static PEL_SHARED int32_t pel_cut_hole(struct pel_span *span, int32_t n,
                                       const struct pel_span *whole,
                                       const struct pel_span *hole)
{
    const struct pel_span r = *whole, h = *hole;
    if (h.x0 >= h.x1)
        return pel_cut_add(span, n, r.x0, r.x1);
    n = pel_cut_add(span, n, r.x0, pel_min(r.x1, h.x0));
    return pel_cut_add(span, n, pel_max(r.x0, h.x1), r.x1);
}

/* Removes `hole` from up to two spans; it splits one of them at most. */
static inline int32_t pel_cut_remove(struct pel_span *span, int32_t n,
                                     const struct pel_span *hole)
{
    const struct pel_span second = span[1];
    int32_t count = n > 0 ? pel_cut_hole(span, 0, &span[0], hole) : 0;
    return n > 1 ? pel_cut_hole(span, count, &second, hole) : count;
}

/* Paints the spans in row y. */
static inline void pel_cut_paint(struct pel_cut *c,
                                 const struct pel_paint *paint, int32_t y)
{
    c->spans.y = y;
    if (c->spans.n)
        paint->fill(paint, &c->spans);
    c->spans.n = 0;
}

#endif
