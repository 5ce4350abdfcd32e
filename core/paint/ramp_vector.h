/* What ramp_walk.c leaves to vectors, where there are any. */
#ifndef PEL_PAINT_RAMP_VECTOR_H
#define PEL_PAINT_RAMP_VECTOR_H

#include "ramp_walk.h"

#if PEL_FAST_64BIT

/* Colours a walk of a padded ramp that may leave it. False when it leaves it by
 * far, or a colour may be wrong: then it is to be coloured otherwise. */
bool pel_ramp_vectors_padded(const struct pel_ramp_mixer *mixer,
                             const struct pel_ramp_walk *walk,
                             pel_color *colors);

#endif
#endif
