/* The rows of a smooth ring, or of what is made of one. */
#ifndef PEL_SMOOTH_RING_ROWS_H
#define PEL_SMOOTH_RING_ROWS_H

#include "../round/ring.h"
#include "round_rows.h"

struct pel_smooth_ring_walk {
    struct pel_smooth_rows rows; /* first: of the outer disc */
    struct pel_smooth_strips hole;
    struct pel_smooth_round outer, inner;
};

/* A legal ring with outer > inner; false: nothing is visible. */
bool pel_smooth_ring_begin(struct pel_smooth_ring_walk *ring,
                           const struct pel_surface *surface,
                           const struct pel_ring_shape *shape,
                           const struct pel_paint *paint);

/* Paints all. */
void pel_smooth_ring_rows(struct pel_smooth_ring_walk *ring);

#endif
