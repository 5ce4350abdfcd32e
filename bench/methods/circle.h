/* Ways to fill a circle of whole radius around a pixel centre, and to find the
 * cell of a radial gradient. */
#ifndef BENCH_METHODS_CIRCLE_H
#define BENCH_METHODS_CIRCLE_H

enum { CIRCLE_MAX = 1024 };

struct circle_method {
    const char *name;

    /* Row y, -r..r, holds the pixels -half[|y|] to half[|y|]; -1: none. */
    void (*rows)(int r, int half[CIRCLE_MAX + 1]);
};

/* Ends with a NULL name. */
extern const struct circle_method circle_methods[];

/* The cell of n over the radius, all in sub-pixels, in float32. */
int cell_by_root(int x, int y, int radius, int n);

/* The same by a table of 256 roots: of the square over that of the radius. */
int cell_by_table(int x, int y, int radius, int n);

#endif
