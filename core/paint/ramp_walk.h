/* A run of pixels along a ramp: positions that are a polynomial of x, stepped
 * by differences, and the colours there. For the gradients of this folder. */
#ifndef PEL_PAINT_RAMP_WALK_H
#define PEL_PAINT_RAMP_WALK_H

#include "../raster/paint.h"
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

/* The colours of the next n pixels, n >= 0. Where PEL_FAST_64BIT is 0 the walk
 * is at the pixel after them then, else it is of no use any more. */
void pel_ramp_run(const struct pel_ramp *ramp, struct pel_ramp_walk *walk,
                  int32_t n, pel_color *colors);

/* Colours n pixels of a walk, and leaves it as pel_ramp_run does. */
typedef void pel_run_function(const void *paint, struct pel_ramp_walk *walk,
                              int32_t n, pel_color *colors);

#if !PEL_FAST_64BIT

/* Pixels (x, y) to (x + n - 1, y), n >= 1. */
struct pel_run {
    int32_t x, y, n;
};

/* Brings a walk to 64 bits, or 63 where the ramp goes there and back, so that
 * it wraps where the ramp does; not one that leaves a padded ramp, which has
 * fewer than 63. Before pel_ramp_run. */
void pel_ramp_widen(const struct pel_ramp *ramp, struct pel_ramp_walk *walk);

/* How small CPUs draw a gradient: with a walk that stays where it is while a
 * few pixels at a time are coloured and put. In ramp_walk_small.c. */
struct pel_walker {
    /* Begins a walk at the first pixel: for how many of n it is right, at least
     * one. */
    int32_t (*begin)(const void *paint, const struct pel_run *run,
                     struct pel_ramp_walk *walk);
    pel_run_function *run;
};

/* The fill function of such a paint, and its colours; `run` ends empty. */
void pel_walker_fill(const struct pel_walker *walker, const void *paint,
                     const struct pel_rows *rows);
void pel_walker_colors(const struct pel_walker *walker, const void *paint,
                       struct pel_run *run, pel_color *colors);

#endif
#endif
