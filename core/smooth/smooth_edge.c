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

/* floor(n 2^bits / d), n < d < 2^25; bits are 16 or 32. */
static PEL_NOINLINE_32 uint32_t fraction(uint32_t n, uint32_t d, int bits)
{
    if (PEL_64BIT || PEL_LONG_MULTIPLY)
        return pel_divide((uint64_t)n << bits, d);
    uint32_t q = 0;
    for (; bits > 0; bits -= 4) {
        ADD_BIT(n, d, q);
        ADD_BIT(n, d, q);
        ADD_BIT(n, d, q);
        ADD_BIT(n, d, q);
    }
    return q;
}

/* The longer way of the two is `whole` times the shorter one and a part, of
 * which 16 bits tell of steep edges. */
int64_t pel_smooth_slope(const struct pel_point *a, const struct pel_point *b,
                         struct pel_rise *rise)
{
    const int32_t dx = pel_magnitude(b->x - a->x), dy = b->y - a->y;
    const int32_t low = pel_min(dx, dy), high = pel_max(dx, dy);
    int32_t whole = 0, rest = 0;
    uint32_t part = 0, inverse = 0;
    if (low > 0) {
        whole = pel_floor_divide(high, low, &rest);
        part = fraction((uint32_t)rest, (uint32_t)low, dx < dy ? 16 : 32);
    }
    if (low < high)
        inverse = fraction((uint32_t)low, (uint32_t)high, 32);
    rise->steep = dx < dy;
    if (dx <= dy >> 14)
        rise->value = 16384 * 32640;
    else if (dx < dy)
        rise->value = (uint32_t)whole * 32640 + (part * 32640 >> 16);
    else if (dx == dy)
        rise->value = PEL_SMOOTH_FULL;
    else
        rise->value = (inverse >> 8) * 255 + ((inverse & 255) * 255 >> 8);
    const int64_t step = dx < dy ? inverse : whole * (INT64_C(1) << 32) + part;
    return b->x < a->x ? -step : step;
}

void pel_smooth_add(const struct pel_smooth_piece *p, uint32_t flip, int32_t x,
                    int32_t n, uint32_t *area)
{
    const uint32_t full = p->height * (255 << 8);
    for (int32_t i = pel_max(0, (p->lo >> 16) - x); i < n; i++) {
        const uint32_t v =
            x + i <= p->hi >> 16 ? pel_smooth_area_in(p, x + i) : full;
        area[i] += (v ^ flip) - flip;
    }
}
