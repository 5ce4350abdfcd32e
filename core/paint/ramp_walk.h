/* A run of pixels along a ramp: positions that are a polynomial of x, stepped
 * by differences, and the colours there. For the gradients of this folder. */
#ifndef PEL_PAINT_RAMP_WALK_H
#define PEL_PAINT_RAMP_WALK_H

#include "color_ramp.h"
#include "paint_colors.h"

/* The position of a pixel and its first three differences from one pixel to
 * the next, in 2^-bits of the way and in two's complement. `inside` promises
 * that every position lies in [0, 1), or that the ramp repeats; otherwise
 * positions must fit 64 bits with their sign. */
struct pel_ramp_walk {
    uint64_t at, d1, d2, d3;
    uint8_t bits; /* 33..64 */
    bool inside;
    int32_t n; /* the pixels that it is right for */
};

/* One pixel on. */
static inline void pel_ramp_step(struct pel_ramp_walk *w)
{
    w->at += w->d1;
    w->d1 += w->d2;
    w->d2 += w->d3;
}

#if PEL_FAST_64BIT

/* Pixels (x, y) to (x + n - 1, y), n >= 1. */
struct pel_run {
    int32_t x, y, n;
};

/* A walk k pixels on, k <= 32,767, but for its n: k (k - 1) / 2 is below 2^29,
 * and k (k - 1) (k - 2) / 6 below 2^43. */
static inline struct pel_ramp_walk pel_ramp_after(struct pel_ramp_walk w,
                                                  int32_t k)
{
    const uint64_t n = (uint64_t)k, pairs = n * (n - 1) / 2;
    const uint64_t triples = pairs * (n - 2) / 3;
    w.at += n * w.d1 + pairs * w.d2 + triples * w.d3;
    w.d1 += n * w.d2 + pairs * w.d3;
    w.d2 += n * w.d3;
    return w;
}

enum { PEL_RAMP_PART = 64 };

/* A ramp made ready for many walks (ramp_vector.h). */
struct pel_ramp_mixer;

void pel_ramp_prepare(struct pel_ramp_mixer *mixer,
                      const struct pel_ramp *ramp);

/* The colours of a walk. `mixer` is a struct pel_ramp_mixer. */
void pel_ramp_run(const void *mixer, const struct pel_ramp_walk *walk,
                  pel_color *colors);

#else

/* The colours of the next n pixels, n >= 0. The walk is at the
 * pixel after them then. */
void pel_ramp_run(const struct pel_ramp *ramp, struct pel_ramp_walk *walk,
                  int32_t n, pel_color *colors);

/* walk.n pixels from (x, y) on. */
struct pel_strip {
    struct pel_ramp_walk walk;
    int32_t x, y;
};

/* How small CPUs draw a gradient: with a walk that stays where it is while a
 * few pixels at a time are coloured and put. In ramp_walk_small.c. */
struct pel_walker {
    size_t part; /* what the functions are handed: this far behind the paint */

    /* Begins a walk at (x, y), for at least one of the n pixels that are wanted
     * there. */
    void (*begin)(const void *part, struct pel_strip *strip);

    /* Colours n pixels of it, and leaves it as pel_ramp_run does. */
    void (*run)(const void *part, struct pel_ramp_walk *walk, int32_t n,
                pel_color *colors);
};

/* The functions of such a paint, a struct pel_color_paint with a walker. */
void pel_walker_fill(const struct pel_paint *paint,
                     const struct pel_spans *spans);
void pel_walker_colors(const struct pel_color_paint *paint, int32_t x,
                       int32_t y, int32_t n, pel_color *colors);

static inline void pel_walker_paint_init(struct pel_color_paint *paint,
                                         const struct pel_walker *walker,
                                         bool opaque)
{
    pel_color_paint_init(paint, pel_walker_colors, opaque);
    paint->paint.fill = pel_walker_fill;
    paint->walker = walker;
}

#endif
#endif
