/* Discs and what is made of two. */
#ifndef PEL_SMOOTH_ROUND_H
#define PEL_SMOOTH_ROUND_H

#include "outline.h"

/* Sets an outline of a disc of legal coordinates, which is one curve, or
 * without a smaller one, which is the second, if inner > 0. Then its quarters
 * may be spread, it may become an oval, and get other sides. */
void pel_smooth_round_set(struct pel_smooth_outline *outline,
                          struct pel_smooth_curve *curve,
                          struct pel_point center, int32_t inner,
                          int32_t outer);

/* Begins to paint it: as pel_smooth_outline_begin. */
bool pel_smooth_round_begin(const struct pel_surface *surface,
                            struct pel_smooth_outline *outline,
                            const struct pel_paint *paint);

#endif
