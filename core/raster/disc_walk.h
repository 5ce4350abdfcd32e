/* The walk over the rows of a circle's disc (disc.h). */
#ifndef PEL_RASTER_DISC_WALK_H
#define PEL_RASTER_DISC_WALK_H

#include "disc.h"

struct pel_disc_walk {
    struct pel_disc disc; /* at row y */
    int32_t y, end;
    int32_t v; /* distance of row y from the centre */
};

/* false: nothing is covered, or the circle is out of range. */
bool pel_disc_walk_start(struct pel_disc_walk *w, struct pel_point center,
                         int32_t radius, const struct pel_rect *clip);

static inline void pel_disc_walk_next(struct pel_disc_walk *w)
{
    pel_disc_next(&w->disc, -pel_square_step(w->v));
    w->v += 256;
    w->y++;
}

#endif
