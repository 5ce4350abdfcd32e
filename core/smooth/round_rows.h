/* Paints smooth rounds (round_strips.h). */
#ifndef PEL_SMOOTH_ROUND_ROWS_H
#define PEL_SMOOTH_ROUND_ROWS_H

#include "round_strips.h"
#include "smooth.h"

/* A round of legal coordinates. */
void pel_smooth_round(const struct pel_surface *surface,
                      const struct pel_smooth_round *round,
                      const struct pel_paint *paint);

#endif
