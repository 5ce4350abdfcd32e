/* Smooth rings. */
#ifndef PEL_SMOOTH_SMOOTH_RING_H
#define PEL_SMOOTH_SMOOTH_RING_H

#include "../round/ring.h"
#include "smooth.h"

PEL_BEGIN_DECLS

/* Paints the disc of radius `outer` without that of radius `inner`, each pixel
 * by its area (smooth.h), as pel_smooth_circle does, and as exactly. Nothing
 * when outer <= inner. The coverage of the inner disc and that of the ring add
 * up to that of the outer disc, or to one more or less. With inner radius 0 it
 * is the disc; pel_ring then lacks the pixel whose centre is the ring's. */
void pel_smooth_ring(const struct pel_surface *surface,
                     const struct pel_ring_shape *ring,
                     const struct pel_paint *paint);
PEL_END_DECLS
#endif
