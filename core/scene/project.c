#include "projector.h"

#include "../base/divide.h"

static void fine_place(const struct pel_projector *p, const int16_t position[3],
                       int64_t out[3])
{
    int32_t place[3];
    for (int k = 0; k < 3; k++)
        place[k] = pel_quantization_value(&p->quantum, k, position[k]);
    for (int k = 0; k < 3; k++)
        out[k] = pel_scale_down(pel_dot(p->rows.row[k], place), p->down) +
                 p->origin[k];
}

/* The nearest whole number to n 2^bits / z, where less than 2^24 in size; z >
 * 0. z is brought to 31 bits, the numerator is then below 2^55, and one of 2^24
 * more keeps it above 0. */
static void quotient(int64_t n, int64_t z, int bits, int32_t *out)
{
    const int down = pel_bits_of((uint64_t)z) - 31;
    if (pel_size_of(n) >> (24 - bits) >= z)
        return;
    const uint32_t divisor = (uint32_t)pel_scale_down(z, down);
    uint64_t sum = (uint64_t)pel_scale_down(n, down - bits);
    sum += ((uint64_t)divisor << 24) + divisor / 2;
    *out = (int32_t)pel_divide(sum, divisor) - (INT32_C(1) << 24);
}

/* The sub-pixel of a place, held in the legal range; is it there by itself? */
static bool on_screen(const struct pel_projector *p, const int64_t c[2],
                      int64_t z, int32_t out[2])
{
    bool on = true;
    for (int k = 0; k < 2; k++) {
        int32_t at = c[k] < 0 ? PEL_GUARD_MIN * 2 : PEL_GUARD_MAX * 2;
        quotient(c[k], z, p->spread[k], &at);
        at += p->center[k];
        out[k] = pel_max(PEL_GUARD_MIN, pel_min(at, PEL_GUARD_MAX));
        on &= out[k] == at;
    }
    return on;
}

void pel_project(const struct pel_projector *projector,
                 const int16_t position[3], struct pel_projected *out)
{
    const struct pel_projector *p = projector;
    int64_t fine[3];
    int32_t at[2];
    fine_place(p, position, fine);
    out->z = (int32_t)(fine[2] >> p->coarse);
    const int64_t z = p->one ? pel_scale_down(p->one, -p->coarse) : fine[2];
    const bool seen = out->z >= p->near_coarse && on_screen(p, fine, z, at);
    out->x = seen ? at[0] : PEL_NOT_ON_SCREEN;
    out->y = seen ? at[1] : 0;
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
    const int64_t place[2] = {coarse[0], coarse[1]};
    int32_t at[2];
    on_screen(projector, place, projector->one ? projector->one : coarse[2],
              at);
    return (struct pel_point){at[0], at[1]};
}
