#include "../base/sqrt.h"
#include "vector.h"

/* v . v <= 3 2^60 < 2^62. The inverse is 2^(62 - shift) / |v|, so v inverse,
 * below 2^62, is 2^30 v / |v| after a shift by 32 - shift. */
bool pel_normalize_fast(const int32_t v[3], pel_cosine unit[3])
{
    uint32_t inverse = 0;
    int shift = 0;
    const uint64_t square = (uint64_t)pel_dot(v, v);
    if (square)
        inverse = pel_inverse_root(square, &shift);
    for (int k = 0; k < 3; k++)
        unit[k] = pel_scaled(v[k], (int32_t)(inverse >> 1), 31 - shift);
    return square != 0;
}
