/* Functions of vector.h, compiled there or in vector.c. */
#ifndef PEL_SCENE_VECTOR_SUMS_H
#define PEL_SCENE_VECTOR_SUMS_H

#include "../base/point.h"

#ifndef PEL_WIDE_SUM
#define PEL_WIDE_SUM static inline
#endif

/* v 2^-n, the nearest (a tie upwards); v 2^-n must fit. -62 <= n <= 62. */
PEL_WIDE_SUM int64_t pel_scale_down(int64_t v, int n)
{
    if (n <= 0)
        return PEL_CAST(int64_t, PEL_CAST(uint64_t, v) << -n);
    return ((v >> (n - 1)) + 1) >> 1;
}

/* a b 2^-n, the nearest (a tie upwards), 0 <= n <= 62; it must fit. */
PEL_WIDE_SUM int32_t pel_scaled(int32_t a, int32_t b, int n)
{
    return PEL_CAST(int32_t, pel_scale_down(pel_long_product(a, b), n));
}

#endif
