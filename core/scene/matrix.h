/* Rotations. */
#ifndef PEL_SCENE_MATRIX_H
#define PEL_SCENE_MATRIX_H

#include "vector.h"

PEL_BEGIN_DECLS

/* Orthogonal, with determinant 1, but for rounding; the identity is
 * PEL_MATRIX_IDENTITY. */
struct pel_matrix {
    pel_cosine row[3][3];
};

#define PEL_MATRIX_IDENTITY                                 \
    {                                                       \
        {                                                   \
            {PEL_COSINE_ONE, 0, 0}, {0, PEL_COSINE_ONE, 0}, \
            {                                               \
                0, 0, PEL_COSINE_ONE                        \
            }                                               \
        }                                                   \
    }

/* The turn around axis 0, 1 or 2 (x, y, z) by an angle in 1/65,536 turns:
 * counter-clockwise for one at whom the axis points. The angle is that of
 * pel_direction, to 2^-15 radians; the matrix is orthogonal to 2^-29. */
void pel_matrix_turn(struct pel_matrix *m, int axis, uint16_t turn);

/* m = a b: b is done first. m may be a. Entries are rounded to the nearest. */
void pel_matrix_multiply(struct pel_matrix *m, const struct pel_matrix *a,
                         const struct pel_matrix *b);

/* out = m v 2^-shift, rounded, 0 <= shift <= 60; for |v[k]| <= 2^31, which
 * keeps sums below 3 2^61. out may be v. */
void pel_matrix_apply(const struct pel_matrix *m, const int64_t v[3], int shift,
                      int64_t out[3]);
PEL_END_DECLS
#endif
