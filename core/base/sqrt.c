#include "sqrt.h"

/* 2^15 / sqrt(i / 64), i from 16 to 64. */
static const uint16_t root_table[49] = {
    65535, 63579, 61788, 60140, 58617, 57205, 55889, 54661, 53510, 52429,
    51411, 50450, 49541, 48679, 47861, 47082, 46341, 45633, 44957, 44310,
    43691, 43096, 42525, 41977, 41449, 40940, 40450, 39977, 39520, 39078,
    38651, 38238, 37837, 37449, 37073, 36708, 36353, 36008, 35673, 35347,
    35030, 34722, 34421, 34128, 33843, 33564, 33292, 33027, 32768,
};

/* Half the shift that brings v, not 0, to [2^60, 2^62). */
static inline int half_shift(uint64_t v)
{
    int shift = 0;
    if (PEL_LONG_MULTIPLY)
        return (pel_leading_zeros(v) - 2) / 2;
    for (; v < UINT64_C(1) << 54; v <<= 8)
        shift += 4;
    for (; v < UINT64_C(1) << 60; v <<= 2)
        shift++;
    return shift;
}

/* 2^31 / sqrt(m / 2^32), 2^30 <= m < 2^32: the table, linear between its values
 * (off by 2^-11.5), then one step of Newton's iteration y (3 - m y^2) / 2,
 * which leaves 3/2 of the square of that. */
static PEL_ALWAYS_INLINE uint32_t root_inverse(uint32_t m)
{
    const uint16_t *t = &root_table[(m >> 26) - 16];
    uint32_t y =
        t[0] * UINT32_C(65536) - (uint32_t)(t[0] - t[1]) * (m >> 10 & 0xFFFF);
    uint32_t square = (uint32_t)(pel_multiply(y, y) >> 32);
    uint32_t one = (uint32_t)(pel_multiply(square, m) >> 32);
    uint64_t next = pel_multiply(y, UINT32_C(3221225472) - one) >> 31;
    return next > UINT32_MAX ? UINT32_MAX : (uint32_t)next;
}

uint32_t pel_inverse_root(uint64_t v, int *shift)
{
    *shift = half_shift(v);
    return root_inverse((uint32_t)(v << 2 * *shift >> 30));
}

/* Times 2^shift the root of v 4^shift = m 2^30 is m / sqrt(m / 2^32) / 2. */
void pel_root_guess(uint64_t v, struct pel_root *r)
{
    v += v == 0;
    r->shift = half_shift(v);
    const uint32_t m = (uint32_t)(v << 2 * r->shift >> 30);
    r->inverse = root_inverse(m);
    r->root = (uint32_t)(pel_multiply(m, r->inverse) >> 32) >> r->shift;
}

/* v less the square of the guess, which v becomes, is below 2^41 2^-shift. That
 * / 2 root, by which the root has to grow, is that inverse 2^(shift - 63); with
 * the upper half of the inverse it is right to 2^-6 and rounded down, so the
 * floor is at most one step away. Products are modulo 2^64, by parts. */
void pel_root_correct(uint64_t v, struct pel_root *r)
{
    v -= pel_multiply(r->root, r->root);
    uint64_t growth = pel_multiply((uint32_t)v, r->inverse >> 16);
    growth += (uint64_t)((uint32_t)(v >> 32) * (r->inverse >> 16)) << 32;
    const int32_t grow = (int32_t)((int64_t)growth >> (47 - r->shift));
    v -= pel_multiply(r->root, (uint32_t)grow) * 2;
    if (grow < 0)
        v += (uint64_t)r->root << 33;
    v -= (uint64_t)(int64_t)(grow * grow);
    r->root += (uint32_t)grow;
    if ((int64_t)v < 0)
        v += 2 * (uint64_t)r->root-- - 1;
    r->root += (int64_t)v > 2 * (int64_t)r->root;
}
