/* Ways to find the angle of (x, y). */
#ifndef BENCH_METHODS_ARCTANGENT_H
#define BENCH_METHODS_ARCTANGENT_H

struct arctangent_method {
    const char *name;
    int size; /* the degree of the polynomial, or the table's steps; 0: none */

    /* Turns, 0..1, from +x towards +y; whole numbers below 2^25 in size, not
     * both 0. */
    double (*turn)(int x, int y);
};

/* The first is Pel's; ends with a NULL name. */
extern const struct arctangent_method arctangent_methods[];

#endif
