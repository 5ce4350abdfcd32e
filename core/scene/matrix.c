#include "matrix.h"

#include "../base/trig.h"

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
            m->row[i][k] = (pel_cosine)pel_scale_down(pel_dot(row, column), 30);
        }
    }
}
