#include "../base/fixed_sqrt.h"
#include "vector.h"

bool pel_vector_fit(const int64_t v[3], int32_t fit[3])
{
    const int bits = pel_bits_of(pel_reach_of(v));
    for (int k = 0; k < 3; k++)
        fit[k] = bits ? (int32_t)pel_scale_down(v[k], bits - 30) : 0;
    return bits != 0;
}

/* The root of the squares' sum, from 2^58 to 3 2^60, is right to 2^-29 of
 * itself. What it is off by scales the vector and does not turn it. Quotients
 * are rounded: a numerator fits 61 bits. */
bool pel_unit_exact(const int64_t v[3], pel_cosine unit[3])
{
    struct pel_root root;
    if (!pel_vector_fit(v, unit))
        return false;
    pel_square_root((uint64_t)pel_dot(unit, unit), &root);
    for (int k = 0; k < 3; k++) {
        const uint64_t n = (uint64_t)pel_size_of(unit[k]) << 30;
        const int32_t q = (int32_t)((n + root.root / 2) / root.root);
        unit[k] = unit[k] < 0 ? -q : q;
    }
    return true;
}
