/* The walk over the rows of a circle's disc (disc.h). */
#ifndef PEL_ROUND_DISC_WALK_H
#define PEL_ROUND_DISC_WALK_H

#include "disc.h"

struct pel_disc_walk {
    struct pel_disc disc; /* at row y */
    int32_t y, end;
    int32_t v; /* distance of row y from the centre */
};

/* false: nothing is covered, or the circle is out of range. */
bool pel_disc_walk_start(struct pel_disc_walk *w,
                         const struct pel_point *center, int32_t radius,
                         const struct pel_rect *clip);

/* What a step to the next row takes from the reach, in 512ths:
 * ((v + 256)^2 - v^2) / 512. */
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
