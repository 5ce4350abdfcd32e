/* Runs of a ramp in vectors, for ramp_walk.c. */
#ifndef PEL_PAINT_RAMP_VECTOR_H
#define PEL_PAINT_RAMP_VECTOR_H

#include "../format/vector.h"
#include "ramp_walk.h"

#if PEL_FAST_64BIT && PEL_VECTORS

/* The colours of a walk that stays inside or repeats the ramp, which does not
 * go there and back. */
void pel_ramp_vectors(const struct pel_ramp_mixer *mixer,
                      const struct pel_ramp_walk *walk, pel_color *colors);

/* The same for a walk of a padded ramp that may leave it. False when it leaves
 * it by far, or a colour may be wrong: then it is to be coloured otherwise. */
bool pel_ramp_vectors_padded(const struct pel_ramp_mixer *mixer,
                             const struct pel_ramp_walk *walk,
                             pel_color *colors);

#endif
#endif
