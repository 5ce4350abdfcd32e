/* The rows of a smooth ring, or of what is made of one. */
#ifndef PEL_SMOOTH_RING_ROWS_H
#define PEL_SMOOTH_RING_ROWS_H

#include "../round/ring.h"
#include "round_rows.h"

struct pel_smooth_ring_walk {
    struct pel_smooth_rows rows; /* first: of the outer disc */
    struct pel_smooth_disc hole;
    struct pel_span
        filled;    /* rows of the batch, whose left halves are to come */
    int32_t at[2]; /* of the disc and the hole in the first of them */
};

/* A legal ring with outer > inner; false: nothing is visible. */
bool pel_smooth_ring_begin(struct pel_smooth_ring_walk *ring,
                           const struct pel_surface *surface,
                           const struct pel_ring_shape *shape,
                           const struct pel_paint *paint);

/* Makes the next batch, which has an image if the rows have; false at the end.
 */
bool pel_smooth_ring_next(struct pel_smooth_ring_walk *ring);

#endif
