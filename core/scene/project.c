#include "projector.h"

static void fine_place(const struct pel_projector *p, const int16_t position[3],
                       int64_t out[3])
{
    int32_t place[3];
    for (int k = 0; k < 3; k++)
        place[k] = pel_mesh_quantum_value(&p->quantum, k, position[k]);
    for (int k = 0; k < 3; k++)
        out[k] = pel_scale_down(pel_dot(p->rows.row[k], place), p->down) +
                 p->origin[k];
}

/* The nearest whole number to n 2^bits / z, less than 2^24 in size; z > 0. z
 * is brought to 31 bits, the numerator is then below 2^55, and one of 2^24 more
 * keeps it above 0. */
static bool quotient(int64_t n, int64_t z, int bits, int32_t *out)
{
    const int down = pel_bits_of((uint64_t)z) - 31;
    if (pel_size_of(n) >> (24 - bits) >= z)
        return false;
    const uint64_t divisor = (uint64_t)pel_scale_down(z, down);
    uint64_t sum = (uint64_t)pel_scale_down(n, down - bits);
    sum += (divisor << 24) + divisor / 2;
    *out = (int32_t)(sum / divisor) - (INT32_C(1) << 24);
    return true;
}

static bool on_screen(const struct pel_projector *p, const int64_t c[3],
                      int32_t out[2])
{
    const int64_t z = p->one ? (int64_t)((uint64_t)1 << p->fine_bits) : c[2];
    for (int k = 0; k < 2; k++) {
        if (!quotient(c[k], z, p->spread[k], &out[k]))
            return false;
        out[k] += p->center[k];
        if (out[k] < PEL_GUARD_MIN || out[k] > PEL_GUARD_MAX)
            return false;
    }
    return true;
}

void pel_project(const struct pel_projector *projector,
                 const int16_t position[3], struct pel_projected *out)
{
    int64_t fine[3];
    int32_t at[2] = {PEL_NOT_ON_SCREEN, 0};
    fine_place(projector, position, fine);
    out->z = (int32_t)(fine[2] >> projector->coarse);
    if (out->z < projector->near || !on_screen(projector, fine, at))
        at[0] = PEL_NOT_ON_SCREEN;
    out->x = at[0];
    out->y = at[1];
}

void pel_project_coarse(const struct pel_projector *projector,
                        const int16_t position[3], int32_t out[3])
{
    int64_t fine[3];
    fine_place(projector, position, fine);
    for (int k = 0; k < 3; k++)
        out[k] = (int32_t)(fine[k] >> projector->coarse);
}

struct pel_point pel_project_clipped(const struct pel_projector *projector,
                                     const int32_t coarse[3])
{
    const int32_t z = projector->one ? projector->one : coarse[2];
    int32_t out[2];
    for (int k = 0; k < 2; k++) {
        if (!quotient(coarse[k], z, projector->spread[k], &out[k]))
            out[k] = coarse[k] < 0 ? PEL_GUARD_MIN * 2 : PEL_GUARD_MAX * 2;
        out[k] = pel_max(PEL_GUARD_MIN,
                         pel_min(out[k] + projector->center[k], PEL_GUARD_MAX));
    }
    return (struct pel_point){out[0], out[1]};
}
