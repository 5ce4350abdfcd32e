/* Outlines of shapes whose rows have one run each: line by line, as the shape
 * is walked over a clip that is a pixel larger than that of the surface. What
 * is inside, and left out, is one pixel smaller than the run at both ends, and
 * not wider than the runs above and below. */
#ifndef PEL_OUTLINE_OUTLINE_LINE_H
#define PEL_OUTLINE_OUTLINE_LINE_H

#include "../raster/cut.h"
#include "../round/disc.h"

struct pel_outline_line {
    struct pel_cut cut;
    struct pel_span above, span; /* the last two lines that were given */
};

static inline void pel_outline_begin(struct pel_outline_line *o,
                                     const struct pel_surface *surface)
{
    pel_cut_begin(&o->cut, surface);
    o->above = o->span = (struct pel_span){0, 0};
}

/* A pixel more on every side, so that the clip makes no edge. */
static inline struct pel_rect pel_outline_clip(const struct pel_surface *s)
{
    const struct pel_rect *c = &s->clip;
    return (struct pel_rect){c->x0 - 1, c->y0 - 1, c->x1 + 1, c->y1 + 1};
}

/* The run of the shape's next line goes there, before the line is put. */
static inline struct pel_span *pel_outline_run(struct pel_outline_line *o)
{
    return o->cut.span;
}

/* Takes line y of the shape, and gives back in the place of its run what is
 * visible of line y - 1, and in `inside` what it does without; false when
 * nothing is. Lines come one after the other, and after the last an empty one.
 */
bool pel_outline_next(struct pel_outline_line *o, int32_t y,
                      struct pel_span *inside);

/* The same, and makes pieces of what is left. */
void pel_outline_cut(struct pel_outline_line *o, int32_t y);

static inline void pel_outline_put(struct pel_outline_line *o,
                                   const struct pel_paint *paint, int32_t y)
{
    pel_outline_cut(o, y);
    pel_cut_paint(&o->cut, paint, y - 1);
}

/* The run of the disc; of none, an empty line. */
static inline void pel_outline_disc(struct pel_outline_line *o,
                                    struct pel_disc *disc,
                                    const struct pel_rect *clip)
{
    if (disc)
        pel_disc_row(disc, clip, pel_outline_run(o));
    else
        *pel_outline_run(o) = (struct pel_span){0, 0};
}

#endif
