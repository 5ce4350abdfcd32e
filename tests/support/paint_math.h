/* Roots and angles for references of paints, in long double without libm; error
 * histograms. */
#ifndef TESTS_SUPPORT_PAINT_MATH_H
#define TESTS_SUPPORT_PAINT_MATH_H

#include <stdint.h>

typedef long double real;

/* To about 2^-60 of the result where long double has 64 bits, 2^-49 where it is
 * double. */
real real_root(real v);

/* The angle of (x, y) in turns, 0 <= result < 1, from +x towards +y; (0, 0) has
 * the angle 0. */
real real_turn(real x, real y);

real real_floor(real v);

static inline real real_abs(real v)
{
    return v < 0 ? -v : v;
}

/* The nearest whole number, a half upwards. */
static inline real real_round(real v)
{
    return real_floor(v + 0.5L);
}

/* Counts errors by size in bins of `step`, and keeps the worst. When the
 * environment's PEL_CSV_DIR names a folder, histogram_end writes NAME.csv
 * there: columns error (upper end of the bin) and count. */
enum { HISTOGRAM_BINS = 64 };

struct histogram {
    const char *name;
    real step, worst;
    uint64_t count[HISTOGRAM_BINS]; /* the last holds all that is larger */
};

void histogram_add(struct histogram *h, real error);
void histogram_end(const struct histogram *h);

/* Texel i of a row or column, or the one that stands for it outside. */
int64_t texel_index(int64_t i, int64_t size, int wrap);

#endif
