#include "matrix.h"

#include "../base/fixed_trig.h"

void pel_matrix_turn(struct pel_matrix *m, int axis, uint16_t turn)
{
    const struct pel_matrix identity = PEL_MATRIX_IDENTITY;
    const struct pel_point d = pel_direction(turn);
    const int64_t v[3] = {d.x, d.y, 0};
    const int a = axis == 2 ? 0 : axis + 1, b = axis == 0 ? 2 : axis - 1;
    pel_cosine unit[3];
    pel_unit_exact(v, unit);
    *m = identity;
    m->row[a][a] = m->row[b][b] = unit[0];
    m->row[a][b] = -unit[1];
    m->row[b][a] = unit[1];
}

void pel_matrix_multiply(struct pel_matrix *m, const struct pel_matrix *a,
                         const struct pel_matrix *b)
{
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            const int32_t column[3] = {b->row[0][k], b->row[1][k],
                                       b->row[2][k]};
            m->row[i][k] =
                (int32_t)pel_scale_down(pel_dot(a->row[i], column), 30);
        }
}

void pel_matrix_apply(const struct pel_matrix *m, const int64_t v[3], int shift,
                      int64_t out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = pel_scale_down(m->row[i][0] * v[0] + m->row[i][1] * v[1] +
                                    m->row[i][2] * v[2],
                                shift);
}

void pel_matrix_apply_back(const struct pel_matrix *m, const int64_t v[3],
                           int shift, int64_t out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = pel_scale_down(m->row[0][i] * v[0] + m->row[1][i] * v[1] +
                                    m->row[2][i] * v[2],
                                shift);
}
