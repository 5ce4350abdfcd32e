/* Vectors and rotations of the 3-D pipeline. Space is right-handed, y up;
 * vectors are columns. */
#ifndef PEL_SCENE_VECTOR_H
#define PEL_SCENE_VECTOR_H

#include "../base/point.h"

PEL_BEGIN_DECLS

/* Positions in the world: 1/65,536 unit, from -16,384 to 16,384 units. A
 * difference of two fits 32 bits unsigned; the dot product of three of them and
 * a unit vector fits 62. */
typedef int32_t pel_length;

#define PEL_LENGTH_MAX (INT32_C(1) << 30)

static inline bool pel_length_legal(pel_length v)
{
    const uint32_t limit = PEL_LENGTH_MAX;
    return PEL_CAST(uint32_t, v) + limit <= 2 * limit;
}

/* n units, for constant expressions too; a constant may have a fraction. */
#define PEL_UNITS(n) PEL_CAST(pel_length, (n)*INT64_C(65536))

/* Components of unit vectors: 2^-30, from -1 to 1. */
typedef int32_t pel_cosine;

#define PEL_COSINE_ONE (INT32_C(1) << 30)

/* Factors of light and material: 1/65,536, from 0 to less than 16. */
typedef int32_t pel_factor;

#define PEL_FACTOR(percent) PEL_CAST(pel_factor, (percent)*INT64_C(65536) / 100)
#define PEL_FACTOR_END (UINT32_C(16) * 65536)

/* pel_scale_down: v 2^-n, -62 <= n <= 62; pel_scaled: a b 2^-n, 0 <= n <= 62;
 * pel_weighted: the dot product 2^-30. The nearest, a tie upwards; it must fit.
 * Inline where a CPU has 64 bits, elsewhere functions of vector.c. */
#if PEL_64BIT
#define PEL_WIDE static inline
#include "vector.inc"
#else
int64_t pel_scale_down(int64_t v, int n);
int32_t pel_scaled(int32_t a, int32_t b, int n);
int32_t pel_weighted(const int32_t a[3], const int32_t b[3]);
#endif

/* a b 2^-n, 0 < n < 32, of numbers without a sign: the nearest, a tie upwards;
 * it must fit. */
static inline uint32_t pel_share(uint32_t a, int32_t b, int n)
{
    if (PEL_SMALL_CODE)
        return PEL_CAST(uint32_t, pel_scaled(PEL_CAST(int32_t, a), b, n));
    const uint64_t product = pel_multiply(a, PEL_CAST(uint32_t, b));
    return PEL_CAST(uint32_t, (product + (UINT64_C(1) << (n - 1))) >> n);
}

/* An upper bound of |v[k]|, with as many bits as the largest of them. */
uint64_t pel_vector_bound(const int64_t v[3]);

/* a b - c d; must fit. */
int64_t pel_minor(int32_t a, int32_t b, int32_t c, int32_t d);

/* The cross product; exact for vectors up to 2^30: below 2^61. */
void pel_cross(const int32_t a[3], const int32_t b[3], int64_t out[3]);

/* unit = v / |v|, each component off by less than 2^-21. No division.
 * |v[k]| <= 2^30; false, and all 0, when v is 0. unit may be v. */
bool pel_normalize_fast(const int32_t v[3], pel_cosine unit[3]);

/* The same, off by less than 2^-28. |v[k]| < 2^62. */
bool pel_normalize(const int64_t v[3], pel_cosine unit[3]);

/* v times a power of two, so that the largest component is in [2^29, 2^30];
 * rounded where v has more bits. False, and all 0, when v is 0. |v[k]| < 2^62.
 */
bool pel_vector_fit(const int64_t v[3], int32_t fit[3]);

/* A rotation: orthogonal, with determinant 1, but for rounding. */
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
 * counter-clockwise when the axis points at the viewer. The angle is that of
 * pel_direction, to 2^-15 radians; the matrix is orthogonal to 1.5 2^-29. */
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
