/* Ways to find which part of a pixel a triangle or a disc covers. */
#ifndef BENCH_METHODS_SMOOTH_H
#define BENCH_METHODS_SMOOTH_H

#include <stdbool.h>

/* px. A disc has a centre and a radius, a triangle vertices in an order whose
 * inside lies left of each side as y grows downwards. */
struct smooth_shape {
    bool is_disc;
    double x[3], y[3], radius;
};

struct smooth_method {
    const char *name;
    int n; /* of samples a side, of sub-scanlines */

    /* Of the pixel whose corner is (x, y), 0 to 1. */
    double (*coverage)(const struct smooth_shape *s, int n, int x, int y);
};

/* Ends with a NULL name. */
extern const struct smooth_method smooth_methods[];

#endif
