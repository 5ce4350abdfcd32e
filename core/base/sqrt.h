/* Exact integer square roots, and reciprocals beside them, without a division.
 */
#ifndef PEL_BASE_SQRT_H
#define PEL_BASE_SQRT_H

#include "point.h"

struct pel_root {
    uint32_t root;    /* floor(sqrt(v)) */
    uint32_t inverse; /* 2^(62 - shift) / sqrt(v), off by less than 2^-22 of it,
                         in [2^31, 2^32) */
    int shift;        /* 0..30 */
};

/* The root of v < 2^62 and its inverse, which is of no use for v = 0. In two
 * steps, for the sake of the stack: guess finds the inverse and a root that is
 * off by less than 2^10, and correct makes that root exact. */
void pel_root_guess(uint64_t v, struct pel_root *root);
void pel_root_correct(uint64_t v, struct pel_root *root);

static inline void pel_square_root(uint64_t v, struct pel_root *root)
{
    pel_root_guess(v, root);
    pel_root_correct(v, root);
}

/* The inverse and the shift alone; v from 1 on. */
uint32_t pel_inverse_root(uint64_t v, int *shift);

#endif
