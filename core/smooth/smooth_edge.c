#include "smooth_edge.h"

#include "../base/divide.h"
#include "../raster/edge.h"

uint32_t pel_smooth_fraction(uint32_t n, uint32_t d)
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

struct pel_rise pel_smooth_rise(int32_t dx, int32_t dy)
{
    struct pel_rise rise = {PEL_SMOOTH_FULL, dx < dy};
    if (dx > dy) {
        const uint32_t f = pel_smooth_fraction((uint32_t)dy, (uint32_t)dx);
        rise.value = (f >> 8) * 255 + ((f & 255) * 255 >> 8);
    } else if (dx <= dy >> 14) {
        rise.value = 16384 * 32640;
    } else if (dx < dy) {
        int32_t rest;
        const int32_t whole = pel_floor_divide(dy, dx, &rest);
        const uint32_t f = pel_smooth_fraction((uint32_t)rest, (uint32_t)dx);
        rise.value = (uint32_t)whole * 32640 + ((f >> 16) * 32640 >> 16);
    }
    return rise;
}
