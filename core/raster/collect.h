/* Collects the spans of a shape into batches for a paint: one span a row in
 * rows one below the other, or spans of one row. */
#ifndef PEL_RASTER_COLLECT_H
#define PEL_RASTER_COLLECT_H

#include "../format/word.h"
#include "paint.h"

/* Spans of a batch. Shapes that collect them take much stack: half as many with
 * PEL_SMALL_CODE on CPUs of 32 bits, where there is little. */
enum {
    PEL_COLLECT_ROWS =
        !PEL_64BIT && PEL_SMALL_CODE ? PEL_BATCH_ROWS / 2 : PEL_ROWS
};

struct pel_collector {
    const struct pel_paint *paint;
    struct pel_spans spans;
    struct pel_span span[PEL_COLLECT_ROWS];
};

static inline void pel_collect_begin(struct pel_collector *c,
                                     const struct pel_surface *surface,
                                     const struct pel_paint *paint)
{
    c->paint = paint;
    c->spans = (struct pel_spans){surface, c->span, 0, 0, 1};
}

static PEL_ALWAYS_INLINE void pel_collect_end(struct pel_collector *c)
{
    if (c->spans.n)
        c->paint->fill(c->paint, &c->spans);
    c->spans.n = 0;
}

/* True when a span in row y can join; the second one sets the step. */
static inline bool pel_collect_joins(struct pel_spans *r, int32_t y)
{
    if (r->n == PEL_COLLECT_ROWS)
        return false;
    if (r->n == 1)
        r->step = y != r->y;
    return y == r->y + r->n * r->step;
}

/* Adds the pixels [x0, x1) of row y: not empty, inside the clip. */
static inline void pel_collect(struct pel_collector *c, int32_t y, int32_t x0,
                               int32_t x1)
{
    if (c->spans.n && !pel_collect_joins(&c->spans, y))
        pel_collect_end(c);
    if (c->spans.n == 0)
        c->spans.y = y;
    PEL_APART(x0);
    c->span[c->spans.n++] = (struct pel_span){x0, x1};
}

/* Adds the part of [x0, x1) that is inside the clip, as row y must be. */
static inline void pel_collect_clipped(struct pel_collector *c, int32_t y,
                                       int32_t x0, int32_t x1)
{
    const struct pel_rect *clip = &c->spans.surface->clip;
    x0 = pel_max(x0, clip->x0);
    x1 = pel_min(x1, clip->x1);
    if (x0 < x1)
        pel_collect(c, y, x0, x1);
}

#endif
