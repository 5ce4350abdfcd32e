#include "smooth_edge.h"

#include "../base/divide.h"
#include "../raster/edge.h"

/* floor(n 2^32 / d), n < d < 2^25. */
static PEL_NOINLINE_32 uint32_t fraction(uint32_t n, uint32_t d)
{
    if (PEL_64BIT || PEL_LONG_MULTIPLY)
        return pel_divide((uint64_t)n << 32, d);
    uint32_t q = 0;
    for (int bits = 32; bits > 0; bits--) {
        n += n;
        q += q;
        if (n >= d) {
            n -= d;
            q++;
        }
    }
    return q;
}

/* 255 2^24 n / d, n < d. */
static uint32_t flat_rise(int32_t n, int32_t d)
{
    const uint32_t f = fraction((uint32_t)n, (uint32_t)d);
    return (f >> 8) * 255 + ((f & 255) * 255 >> 8);
}

/* 255 2^7 n / d, d < n < 2^14 d. */
static uint32_t steep_rise(int32_t n, int32_t d)
{
    int32_t rest;
    const int32_t whole = pel_floor_divide(n, d, &rest);
    const uint32_t f = fraction((uint32_t)rest, (uint32_t)d);
    return (uint32_t)whole * 32640 + ((f >> 16) * 32640 >> 16);
}

struct pel_rise pel_smooth_rise(const struct pel_point *a,
                                const struct pel_point *b)
{
    const int32_t dx = pel_magnitude(b->x - a->x), dy = b->y - a->y;
    struct pel_rise rise = {PEL_SMOOTH_FULL, dx < dy};
    if (dx > dy)
        rise.value = flat_rise(dy, dx);
    else if (dx <= dy >> 14)
        rise.value = 16384 * 32640;
    else if (dx < dy)
        rise.value = steep_rise(dy, dx);
    return rise;
}

int64_t pel_smooth_step(const struct pel_point *a, const struct pel_point *b)
{
    const int32_t dx = pel_magnitude(b->x - a->x), dy = b->y - a->y;
    int32_t rest;
    const int64_t whole = pel_floor_divide(dx, dy, &rest);
    const int64_t step =
        whole * (INT64_C(1) << 32) + fraction((uint32_t)rest, (uint32_t)dy);
    return b->x < a->x ? -step : step;
}
