#include "vector.h"

#include "../base/sqrt.h"
#include "../base/trig.h"

#ifndef PEL_WIDE /* vector.h */
#define PEL_WIDE
#include "vector.inc"
#endif

uint64_t pel_vector_bound(const int64_t v[3])
{
    uint64_t bound = 0;
    for (const int64_t *end = v + 3; v != end; v++)
        bound |= (uint64_t)pel_size_of(*v);
    return bound;
}

int64_t pel_minor(int32_t a, int32_t b, int32_t c, int32_t d)
{
    return pel_long_product(a, b) - pel_long_product(c, d);
}

/* v . v <= 3 2^60 < 2^62. The inverse is 2^(62 - shift) / |v|, and |v| 2^shift
 * is below 2^31: so v 2^shift inverse is 2^30 v / |v| after a shift by 32,
 * which is the same for all vectors. */
bool pel_normalize_fast(const int32_t v[3], pel_cosine unit[3])
{
    uint32_t inverse = 0;
    int shift = 0;
    const uint64_t square = (uint64_t)pel_dot(v, v);
    if (square)
        inverse = pel_inverse_root(square, &shift);
    PEL_UNROLL
    for (int k = 0; k < 3; k++)
        unit[k] = pel_scaled(v[k] * (int32_t)(UINT32_C(1) << shift),
                             (int32_t)(inverse >> 1), 31);
    return square != 0;
}

bool pel_vector_fit(const int64_t v[3], int32_t fit[3])
{
    const int bits = pel_bits_of(pel_vector_bound(v));
    for (int k = 0; k < 3; k++)
        fit[k] = bits ? (int32_t)pel_scale_down(v[k], bits - 30) : 0;
    return bits != 0;
}

/* The fast one is turned by less than half of its last bits; its length is 1 +
 * e / 2 with e = square - 1, |e| < 2^-19, so that what e / 2 leaves is 2^-40.
 */
bool pel_normalize(const int64_t v[3], pel_cosine unit[3])
{
    if (!pel_vector_fit(v, unit))
        return false;
    pel_normalize_fast(unit, unit);
    const int32_t longer =
        (int32_t)((pel_dot(unit, unit) - (INT64_C(1) << 60)) >> 31);
    for (int k = 0; k < 3; k++)
        unit[k] -= pel_scaled(unit[k], longer, 30);
    return true;
}

void pel_matrix_turn(struct pel_matrix *m, int axis, uint16_t turn)
{
    const struct pel_matrix identity = PEL_MATRIX_IDENTITY;
    const struct pel_point d = pel_direction(turn);
    const int64_t v[3] = {d.x, d.y, 0};
    const int a = axis == 2 ? 0 : axis + 1, b = axis == 0 ? 2 : axis - 1;
    pel_cosine unit[3];
    pel_normalize(v, unit);
    *m = identity;
    m->row[a][a] = m->row[b][b] = unit[0];
    m->row[a][b] = -unit[1];
    m->row[b][a] = unit[1];
}

void pel_matrix_apply(const struct pel_matrix *m, const int64_t v[3], int shift,
                      int64_t out[3])
{
    const int64_t x = v[0], y = v[1], z = v[2];
    for (int i = 0; i < 3; i++)
        out[i] = pel_scale_down(
            m->row[i][0] * x + m->row[i][1] * y + m->row[i][2] * z, shift);
}

void pel_matrix_multiply(struct pel_matrix *m, const struct pel_matrix *a,
                         const struct pel_matrix *b)
{
    for (int i = 0; i < 3; i++) {
        const pel_cosine row[3] = {a->row[i][0], a->row[i][1], a->row[i][2]};
        for (int k = 0; k < 3; k++) {
            const pel_cosine column[3] = {b->row[0][k], b->row[1][k],
                                          b->row[2][k]};
            m->row[i][k] = pel_weighted(row, column);
        }
    }
}

void pel_cross(const int32_t a[3], const int32_t b[3], int64_t out[3])
{
    for (int k = 0; k < 3; k++) {
        const int i = k == 2 ? 0 : k + 1, j = k == 0 ? 2 : k - 1;
        out[k] = pel_minor(a[i], b[j], a[j], b[i]);
    }
}
