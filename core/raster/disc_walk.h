/* The walk over the rows of a circle's disc (disc.h). */
#ifndef PEL_RASTER_DISC_WALK_H
#define PEL_RASTER_DISC_WALK_H

#include "disc.h"

struct pel_disc_walk {
    struct pel_disc disc;
    int64_t reach; /* of row y */
    int32_t y, end;
    int32_t v; /* distance of row y from the centre */
};

/* false: nothing is covered, or the circle is out of range. */
bool pel_disc_walk_start(struct pel_disc_walk *w, struct pel_point center,
                         int32_t radius, const struct pel_rect *clip);

/* The run of row y. */
static inline struct pel_row pel_disc_walk_row(struct pel_disc_walk *w)
{
    return pel_disc_row(&w->disc, w->reach);
}

static inline void pel_disc_walk_next(struct pel_disc_walk *w)
{
    w->reach -= pel_square_step(w->v);
    w->v += 256;
    w->y++;
}

#endif
