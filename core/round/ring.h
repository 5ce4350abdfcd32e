/* Filled rings. */
#ifndef PEL_ROUND_RING_H
#define PEL_ROUND_RING_H

#include "../raster/paint.h"

PEL_BEGIN_DECLS

struct pel_ring_shape {
    struct pel_point center;
    int32_t inner, outer; /* 1/256 px, 0..32,767 px */
};

/* Fills the pixels whose centre (X, Y) satisfies
 * inner^2 < (X - center.x)^2 + (Y - center.y)^2 <= outer^2, all in sub-pixels,
 * exactly: the disc of pel_circle with radius `outer` without the one with
 * radius `inner`. So rings tile: the inner disc, the ring around it and the
 * next ring cover every pixel once. Nothing when outer <= inner. */
void pel_ring(const struct pel_surface *surface,
              const struct pel_ring_shape *ring, const struct pel_paint *paint);
PEL_END_DECLS
#endif
