/* Curves along a row, for paints whose exact value at a pixel is costly: knots
 * with the exact value and slope, and between two of them the cubic that has
 * both. The error of that cubic over K pixels is at most K^4 / 384 times the
 * fourth derivative, which falls fast with the distance from the paint's
 * centre, so pieces grow with the distance: a piece is the largest block of
 * 64, 32, 16, 8 or 4 pixels, at a multiple of its size, all of whose centres
 * are far enough away. What a pixel shows so depends on the pixel alone, not on
 * the run that it is part of; where no block is far enough, every pixel has an
 * exact value of its own. */
#ifndef PEL_PAINT_CURVE_H
#define PEL_PAINT_CURVE_H

#include <stddef.h>

#include "../base/point.h"
#include "ramp_walk.h"

enum { PEL_PIECE_MIN_LOG2 = 2, PEL_PIECE_MAX_LOG2 = 6 };

/* Farther than any pixel, and its square fits. */
enum { PEL_CURVE_NOWHERE = (1 << 30) - 1 };

/* Value and slope at a pixel's centre, the slope per pixel: times the size of a
 * piece it must stay below 2^60. Any unit; the value in two's complement. */
struct pel_knot {
    uint64_t value;
    int64_t slope;
};

struct pel_curve;

#if PEL_FAST_64BIT

/* Colours a walk. */
typedef void pel_curve_run(const void *context,
                           const struct pel_ramp_walk *walk, pel_color *colors);

#else

/* Colours n pixels of a walk, and leaves it as pel_ramp_run does. */
typedef void pel_curve_run(const struct pel_curve *curve,
                           struct pel_ramp_walk *walk, int32_t n,
                           pel_color *colors);

#endif

/* A member of its paint's struct, `curve`. */
struct pel_curve {
    struct pel_point center;

    /* How far the centres of a piece of 4, 8, 16, 32, 64 pixels must be from
     * there, in sub-pixels, the next piece's first one included. */
    const int32_t *far;

#if !PEL_FAST_64BIT
    /* The knot at (x, y) from the centre: its value, and returns its slope. */
    int64_t (*knot)(const struct pel_curve *curve, int32_t x, int32_t y,
                    uint64_t *value);
#endif

    pel_curve_run *run;

    uint8_t bits; /* of the unit: pel_ramp_walk */

    /* Walks whose knots are below this are `inside` (pel_ramp_walk). */
    uint64_t limit;

    /* Where all centres are so far from the paint's, in sub-pixels, every value
     * is 1 or more, by more than the errors of knots and cubics;
     * PEL_CURVE_NOWHERE when that is so, or values repeat. */
    int32_t outside;
};

#if !PEL_FAST_64BIT

/* The functions of a struct pel_walker whose part is a curve. */
void pel_curve_begin(const void *curve, struct pel_strip *strip);
void pel_curve_follow(const void *curve, struct pel_ramp_walk *walk, int32_t n,
                      pel_color *colors);

#endif

/* The paint of a curve. */
#define PEL_CURVE_PAINT(type, pointer)                                   \
    ((const type *)(const void *)((const char *)(pointer)-offsetof(type, \
                                                                   curve)))
#endif
