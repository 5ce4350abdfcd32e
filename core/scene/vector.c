#include "vector.h"

#if !PEL_64BIT
#define PEL_WIDE_SUM
#include "vector_sums.h"
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
