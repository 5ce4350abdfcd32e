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
    struct pel_row above, row; /* the last two lines that were given */
};

static inline void pel_outline_begin(struct pel_outline_line *o,
                                     const struct pel_surface *surface,
                                     const struct pel_paint *paint)
{
    pel_cut_begin(&o->cut, surface, paint);
    o->above = o->row = (struct pel_row){0, 0};
}

/* A pixel more on every side, so that the clip makes no edge. */
static inline struct pel_rect pel_outline_clip(const struct pel_surface *s)
{
    const struct pel_rect *c = &s->clip;
    return (struct pel_rect){c->x0 - 1, c->y0 - 1, c->x1 + 1, c->y1 + 1};
}

/* Takes line y of the shape in `run`, and gives back there what is visible of
 * line y - 1, and in `inside` what it does without; false when nothing is.
 * Lines come one after the other, and after the last an empty one. */
static inline bool pel_outline_next(struct pel_outline_line *o, int32_t y,
                                    struct pel_row *run, struct pel_row *inside)
{
    const struct pel_rect *clip = &o->cut.rows.surface->clip;
    const struct pel_row row = o->row;
    inside->x0 = pel_max(row.x0 + 1, pel_max(o->above.x0, run->x0));
    inside->x1 = pel_min(row.x1 - 1, pel_min(o->above.x1, run->x1));
    o->above = row;
    o->row = *run;
    run->x0 = pel_max(row.x0, clip->x0);
    run->x1 = pel_min(row.x1, clip->x1);
    return y > clip->y0 && y <= clip->y1;
}

static inline void pel_outline_put(struct pel_outline_line *o, int32_t y,
                                   struct pel_row run)
{
    struct pel_row inside;
    if (!pel_outline_next(o, y, &run, &inside))
        return;
    pel_cut_hole(&o->cut, &run, &inside);
    pel_cut_paint(&o->cut, y - 1);
}

/* The run of the disc; of none, an empty line. */
static inline void pel_outline_disc(struct pel_outline_line *o, int32_t y,
                                    struct pel_disc *disc,
                                    const struct pel_rect *clip)
{
    struct pel_row run = {0, 0};
    if (disc)
        pel_disc_row(disc, clip, &run);
    pel_outline_put(o, y, run);
}

#endif
