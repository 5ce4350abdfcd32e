/* What ramp_walk.c leaves to vectors, where there are any. */
#ifndef PEL_PAINT_RAMP_VECTOR_H
#define PEL_PAINT_RAMP_VECTOR_H

#include "../format/vector.h"
#include "ramp_walk.h"

#if PEL_FAST_64BIT

/* A ramp made ready for many walks. */
struct pel_ramp_mixer {
    const struct pel_ramp *ramp;
#if PEL_VECTORS
    struct pel_ramp_channel {
        pel_u16x8 from, way; /* 255 a + 128, b - a */
    } channel[4];            /* of a ramp of two colours; alpha is the last */
    uint32_t shift;          /* from 32 bits to cells of 2^(32 - shift) */
#endif

    /* Colours walks of up to PEL_RAMP_PART pixels that stay inside or repeat;
     * NULL where that is no faster. */
    void (*run)(const struct pel_ramp_mixer *mixer,
                const struct pel_ramp_walk *walk, pel_color *colors);
};

/* Colours a walk of a padded ramp that may leave it. False when it leaves it by
 * far, or a colour may be wrong: then it is to be coloured otherwise. */
bool pel_ramp_vectors_padded(const struct pel_ramp_mixer *mixer,
                             const struct pel_ramp_walk *walk,
                             pel_color *colors);

#endif
#endif
