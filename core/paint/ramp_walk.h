/* A run of pixels along a ramp: positions that are a polynomial of x, stepped
 * by differences, and the colours there. For the gradients of this folder. */
#ifndef PEL_PAINT_RAMP_WALK_H
#define PEL_PAINT_RAMP_WALK_H

#include "color_ramp.h"

/* The position of a pixel and its first three differences from one pixel to
 * the next, in 2^-bits of the way and in two's complement. `inside` promises
 * that every position lies in [0, 1), or that the ramp repeats; otherwise
 * positions must fit 64 bits with their sign. */
struct pel_ramp_walk {
    uint64_t at, d1, d2, d3;
    uint8_t bits; /* 33..64 */
    bool inside;
};

/* One pixel on. */
static inline void pel_ramp_step(struct pel_ramp_walk *w)
{
    w->at += w->d1;
    w->d1 += w->d2;
    w->d2 += w->d3;
}

/* The colours of the next n pixels, n >= 0. */
void pel_ramp_run(const struct pel_ramp *ramp, const struct pel_ramp_walk *walk,
                  int32_t n, pel_color *colors);

#endif
