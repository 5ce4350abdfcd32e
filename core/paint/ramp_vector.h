/* Ramps made ready for many pixels, where a CPU has 64 bits: colours with
 * vectors, where there are any. */
#ifndef PEL_PAINT_RAMP_VECTOR_H
#define PEL_PAINT_RAMP_VECTOR_H

#include "../format/vector.h"
#include "ramp_walk.h"

#if PEL_FAST_64BIT

struct pel_grid;

struct pel_ramp_mixer {
    const struct pel_ramp *ramp;

    /* Colours walks of up to PEL_RAMP_PART pixels that stay inside or repeat;
     * NULL where that is no faster. */
    void (*run)(const struct pel_ramp_mixer *mixer,
                const struct pel_ramp_walk *walk, pel_color *colors);

    /* Colours such a walk of a padded ramp that may leave it; false when it
     * leaves it by far or a colour may be wrong: then it is to be coloured
     * otherwise. NULL where that is no faster. */
    bool (*padded)(const struct pel_ramp_mixer *mixer,
                   const struct pel_ramp_walk *walk, pel_color *colors);

#if PEL_VECTORS
    /* Colour the rows of a grid (ramp_lanes.h), except where it notes a doubt.
     * All positions are inside or repeat; the second takes those of a padded
     * ramp that may leave it, from 0 to 2 in 2^-30 of the way. Set where `run`
     * is. */
    void (*rows)(const struct pel_ramp_mixer *mixer, struct pel_grid *grid);
    void (*rows_padded)(const struct pel_ramp_mixer *mixer,
                        struct pel_grid *grid);

    struct pel_ramp_channel {
        pel_u16x8 from, way; /* 255 a + 128, b - a */
    } channel[4];            /* of a ramp of two colours; alpha is the last */
    uint32_t shift;          /* from 32 bits to cells of 2^(32 - shift) */
#endif
};

#if PEL_VECTORS

/* Set a mixer's functions and what they use: for a ramp of two colours, and for
 * any other. The ramp is not reflected. */
void pel_ramp_prepare_mix(struct pel_ramp_mixer *mixer);
void pel_ramp_prepare_table(struct pel_ramp_mixer *mixer);

#endif
#endif
#endif
