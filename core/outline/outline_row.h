/* Outlines of shapes with one span in each row. The shape is walked with a clip
 * one pixel larger than that of the surface. The inside of a span is left out:
 * all but both end pixels, where the spans above and below cover it. */
#ifndef PEL_OUTLINE_OUTLINE_ROW_H
#define PEL_OUTLINE_OUTLINE_ROW_H

#include "../raster/cut.h"
#include "../round/disc.h"

struct pel_outline_row {
    struct pel_cut cut;
    struct pel_span above, span; /* the last two rows given */
};

static inline void pel_outline_begin(struct pel_outline_row *o,
                                     const struct pel_surface *surface)
{
    pel_cut_begin(&o->cut, surface);
    o->above = o->span = (struct pel_span){0, 0};
}

/* The clip, one pixel larger on every side, so that it makes no outline. */
static inline struct pel_rect pel_outline_clip(const struct pel_surface *s)
{
    const struct pel_rect *c = &s->clip;
    return (struct pel_rect){c->x0 - 1, c->y0 - 1, c->x1 + 1, c->y1 + 1};
}

/* Memory for the span of the next row, to be set before pel_outline_put. */
static inline struct pel_span *pel_outline_span(struct pel_outline_row *o)
{
    return o->cut.span;
}

/* Takes row y of the shape. Replaces its span by the visible part of row y - 1
 * and sets `inside`, which the outline leaves out of that part. false when row
 * y - 1 is not visible. Rows come one after the other, then an empty one. */
bool pel_outline_next(struct pel_outline_row *o, int32_t y,
                      struct pel_span *inside);

/* The same, and sets the spans of the outline in row y - 1. */
void pel_outline_cut(struct pel_outline_row *o, int32_t y);

static inline void pel_outline_put(struct pel_outline_row *o,
                                   const struct pel_paint *paint, int32_t y)
{
    pel_outline_cut(o, y);
    pel_cut_paint(&o->cut, paint, y - 1);
}

/* Sets the span of a row of the disc; an empty one for NULL. */
static inline void pel_outline_disc(struct pel_outline_row *o,
                                    struct pel_disc *disc,
                                    const struct pel_rect *clip)
{
    *pel_outline_span(o) = (struct pel_span){0, 0};
    if (disc)
        pel_disc_row(disc, clip, pel_outline_span(o));
}

#endif
