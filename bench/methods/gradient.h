/* Ways to interpolate a channel over a triangle: a plane, stepped from pixel to
 * pixel by gradients of a few fraction bits. */
#ifndef BENCH_METHODS_GRADIENT_H
#define BENCH_METHODS_GRADIENT_H

#include <pel/pel.h>

struct gradient {
    int64_t at, dx, dy; /* at the centre of the first vertex's pixel; 2^-bits */
    float base, right, down;
    int32_t x, y; /* of that pixel */
};

struct gradient_method {
    const char *name;
    int bits;       /* of a fraction; 0: float32 */
    bool saturates; /* a gradient beyond 32 bits is the largest of them */
};

/* Ends with a NULL name. */
extern const struct gradient_method gradient_methods[];

/* The triangle has area. */
void gradient_set(struct gradient *g, const struct gradient_method *m,
                  const struct pel_point v[3], const int32_t value[3]);

/* The value at the centre of (x, y), rounded, 0..255. */
int32_t gradient_at(const struct gradient *g, const struct gradient_method *m,
                    int32_t x, int32_t y);

#endif
