/* Ways to put a texture in perspective along a row. */
#ifndef BENCH_METHODS_PERSPECTIVE_H
#define BENCH_METHODS_PERSPECTIVE_H

/* u and the distance z of both ends of a row; both may go on beyond them. */
struct lane {
    double length; /* px */
    double u[2], z[2];
};

/* The texel coordinate x px from the first end, exactly. */
double lane_exact(const struct lane *l, double x);

/* Linear from end to end. */
double lane_affine(const struct lane *l, double x);

/* Exact every `span` px, counted from the centre of the first pixel, and linear
 * between; the last span ends with the row. */
double lane_span(const struct lane *l, double x, int span);

/* A division in float32 at every pixel. */
double lane_float(const struct lane *l, double x);

/* The largest error of a line from x0 to x1 instead of the curve, at most du (r
 * - 1) / 4, du texels, r the ratio of the distances. 0 where an end is not in
 * front of the eye: there is no such line. */
double lane_bound(const struct lane *l, double x0, double x1);

#endif
