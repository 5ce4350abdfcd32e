/* pel_square_root() for 64-bit CPUs, to be written out where it is called
 * often. The root is that of sqrt.c, from whole products. */
#ifndef PEL_BASE_ROOT_H
#define PEL_BASE_ROOT_H

#include "root_steps.h"
#include "sqrt.h"

/* The root times 2^shift, of v 4^shift = m 2^30, is m / sqrt(m / 2^32) / 2: off
 * by less than 2^31 2^-22 after the shift, so |rest| < 2^41 2^-shift. rest / 2
 * root, to which the root has to grow, is rest inverse 2^(shift - 63); with the
 * upper half of the inverse that is right to 2^-6 and rounded down, so the
 * floor is at most one step away. */
static inline struct pel_root pel_root_of(uint64_t v)
{
    const uint64_t w = v ? v : 1;
    const int shift = pel_root_half_shift(w);
    const uint32_t m = (uint32_t)(w << 2 * shift >> 30);
    const uint32_t inverse = pel_root_inverse(m);
    uint64_t g = ((uint64_t)m * inverse >> 32) >> shift;
    int64_t rest = (int64_t)(v - g * g) * (int64_t)(inverse >> 16);
    g += (uint64_t)(rest >> (47 - shift));
    if (g * g > v)
        g--;
    g += (g + 1) * (g + 1) <= v;
    return (struct pel_root){(uint32_t)g, inverse, shift};
}

#endif
