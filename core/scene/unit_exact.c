#include "vector.h"

bool pel_vector_fit(const int64_t v[3], int32_t fit[3])
{
    const int bits = pel_bits_of(pel_vector_bound(v));
    for (int k = 0; k < 3; k++)
        fit[k] = bits ? (int32_t)pel_scale_down(v[k], bits - 30) : 0;
    return bits != 0;
}

/* The near one is turned by less than half of its last bits; its length is 1 +
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
