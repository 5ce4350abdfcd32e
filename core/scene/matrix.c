#include "matrix.h"

#include <string.h>

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

/* A sum over a row or, with a step of 3, a column. */
static int64_t sum_of(const pel_cosine *m, int step, const int64_t v[3])
{
    int64_t sum = 0;
    for (int k = 0; k < 3; k++)
        sum += m[k * step] * v[k];
    return sum;
}

void pel_matrix_apply(const struct pel_matrix *m, const int64_t v[3], int shift,
                      int64_t out[3])
{
    int64_t result[3];
    for (int i = 0; i < 3; i++)
        result[i] = pel_scale_down(sum_of(m->row[i], 1, v), shift);
    memcpy(out, result, sizeof result);
}

void pel_matrix_apply_back(const struct pel_matrix *m, const int64_t v[3],
                           int shift, int64_t out[3])
{
    int64_t result[3];
    for (int i = 0; i < 3; i++)
        result[i] = pel_scale_down(sum_of(&m->row[0][i], 3, v), shift);
    memcpy(out, result, sizeof result);
}

void pel_matrix_multiply(struct pel_matrix *m, const struct pel_matrix *a,
                         const struct pel_matrix *b)
{
    for (int i = 0; i < 3; i++) {
        int64_t row[3];
        for (int k = 0; k < 3; k++)
            row[k] = a->row[i][k];
        pel_matrix_apply_back(b, row, 30, row);
        for (int k = 0; k < 3; k++)
            m->row[i][k] = (pel_cosine)row[k];
    }
}
