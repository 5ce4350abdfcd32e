#include "sqrt.h"

#include "point.h"
#include "root_steps.h"

/* Times 2^shift the root of v 4^shift = m 2^30 is m / sqrt(m / 2^32) / 2. */
void pel_root_guess(uint64_t v, struct pel_root *r)
{
    v += v == 0;
    r->shift = pel_root_half_shift(v);
    const uint32_t m = (uint32_t)(v << 2 * r->shift >> 30);
    r->inverse = pel_root_inverse(m);
    r->root = (uint32_t)(pel_multiply(m, r->inverse) >> 32) >> r->shift;
}

/* v less the square of the guess, which v becomes, is below 2^41 2^-shift. That
 * / 2 root, by which the root has to grow, is that inverse 2^(shift - 63); with
 * the upper half of the inverse it is right to 2^-6 and rounded down, so the
 * floor is at most one step away. Products are modulo 2^64, by parts. */
void pel_root_settle(uint64_t v, struct pel_root *r)
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
