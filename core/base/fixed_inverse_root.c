#include "../pel_config.h"
#include "fixed_sqrt.h"

/* 2^15 / sqrt(i / 64), i from 16 to 64. */
static const uint16_t table[49] = {
    65535, 63579, 61788, 60140, 58617, 57205, 55889, 54661, 53510, 52429,
    51411, 50450, 49541, 48679, 47861, 47082, 46341, 45633, 44957, 44310,
    43691, 43096, 42525, 41977, 41449, 40940, 40450, 39977, 39520, 39078,
    38651, 38238, 37837, 37449, 37073, 36708, 36353, 36008, 35673, 35347,
    35030, 34722, 34421, 34128, 33843, 33564, 33292, 33027, 32768,
};

/* Half the shift that brings v, not 0, to [2^60, 2^62). */
#if defined(__GNUC__) && PEL_FAST_64BIT

static int half_shift(uint64_t v)
{
    return (__builtin_clzll(v) - 2) / 2;
}

#else

static int half_shift(uint64_t v)
{
    int shift = 0;
    for (; v < UINT64_C(1) << 60; v <<= 2)
        shift++;
    return shift;
}

#endif

/* 2^31 / sqrt(m / 2^32), 2^30 <= m < 2^32: the table, linear between its values
 * (off by 2^-11.5), then one step of Newton's iteration y (3 - m y^2) / 2,
 * which leaves 3/2 of the square of that. */
static uint32_t inverse_root(uint32_t m)
{
    const uint16_t *t = &table[(m >> 26) - 16];
    uint32_t y =
        t[0] * UINT32_C(65536) - (uint32_t)(t[0] - t[1]) * (m >> 10 & 0xFFFF);
    uint32_t square = (uint32_t)((uint64_t)y * y >> 32);
    uint32_t one = (uint32_t)((uint64_t)square * m >> 32);
    uint64_t next = (uint64_t)y * (UINT32_C(3221225472) - one) >> 31;
    return next > UINT32_MAX ? UINT32_MAX : (uint32_t)next;
}

uint32_t pel_inverse_root(uint64_t v, int *shift)
{
    *shift = half_shift(v);
    return inverse_root((uint32_t)(v << 2 * *shift >> 30));
}
