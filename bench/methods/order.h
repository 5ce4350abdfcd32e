/* Keys by which a painter sorts triangles, the farthest first. */
#ifndef BENCH_METHODS_ORDER_H
#define BENCH_METHODS_ORDER_H

struct order_method {
    const char *name;
    double (*key)(const double z[3]);
};

/* Ends with a NULL name. */
extern const struct order_method order_methods[];

#endif
