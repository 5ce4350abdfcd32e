/* The rows of a disc around one centre (disc.h). */
#ifndef PEL_ROUND_DISC_WALK_H
#define PEL_ROUND_DISC_WALK_H

#include "disc.h"

struct pel_disc_walk {
    struct pel_disc disc; /* at row y */
    int32_t y, end;
    int32_t v; /* distance of row y from the centre, 1/256 px */
};

/* false: nothing is covered, or the disc is out of range (PEL_ASSERT). */
bool pel_disc_walk_start(struct pel_disc_walk *w,
                         const struct pel_point *center, int32_t radius,
                         const struct pel_rect *clip);

/* The loss of half_width2 on the step to the next row, in units of 512. */
static inline int32_t pel_disc_walk_step(const struct pel_disc_walk *w)
{
    return w->v + 128;
}

static inline void pel_disc_walk_next(struct pel_disc_walk *w)
{
    pel_disc_step(&w->disc, -pel_disc_walk_step(w));
    w->v += 256;
    w->y++;
}

#endif
