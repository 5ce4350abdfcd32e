#include "smooth_edge.h"

#include "../base/divide.h"
#include "../raster/edge.h"

/* The next bit of a quotient. */
#define ADD_BIT(n, d, q) \
    do {                 \
        n += n;          \
        q += q;          \
        if (n >= d) {    \
            n -= d;      \
            q++;         \
        }                \
    } while (0)

/* floor(n 2^32 / d), n < d < 2^25. */
static PEL_NOINLINE_32 uint32_t fraction(uint32_t n, uint32_t d)
{
    if (PEL_64BIT || PEL_LONG_MULTIPLY)
        return pel_divide((uint64_t)n << 32, d);
    uint32_t q = 0;
    for (int bits = 32; bits > 0; bits -= 4) {
        ADD_BIT(n, d, q);
        ADD_BIT(n, d, q);
        ADD_BIT(n, d, q);
        ADD_BIT(n, d, q);
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

/* Of a pixel that the piece crosses. */
static inline uint32_t area_in(const struct pel_smooth_piece *p, int32_t x)
{
    const int32_t a = p->lo >> 16, b = p->hi >> 16;
    const uint32_t low = p->lo & 0xFFFF, high = p->hi & 0xFFFF;
    const uint32_t full = p->height * (255 << 8);
    if (a == b)
        return full - ((low + high) * (p->height >> 1) >> 8) * 255;
    if (x == a)
        return pel_smooth_corner(&p->rise, 65536 - low);
    if (x == b)
        return full - pel_smooth_corner(&p->rise, high);
    return pel_smooth_between(&p->rise, 65536 - low) +
           (uint32_t)(x - a - 1) * p->rise.value;
}

void pel_smooth_add(const struct pel_smooth_piece *p, uint32_t flip, int32_t x,
                    int32_t n, uint32_t *area)
{
    for (; n > 0; n--, x++, area++) {
        uint32_t v = p->height * (255 << 8);
        if (x < p->lo >> 16)
            continue;
        if (x <= p->hi >> 16)
            v = area_in(p, x);
        *area += (v ^ flip) - flip;
    }
}
