/* What the files about strips share: roots, and the areas between arcs and
 * their chords. */
#ifndef PEL_SMOOTH_STRIP_ARC_H
#define PEL_SMOOTH_STRIP_ARC_H

#include "strip.h"

extern const uint8_t pel_smooth_first_guess[96];

/* 2^10 sqrt(n) of n >= 2^30, off by less than 4. With x = n / 2^16, a step of
 * Newton's iteration gives r = 2^23 / sqrt(x) to 2^-13 of it. So x r is a root
 * that is off by less than 10, and the rest over twice the root gives 10 bits
 * more: q < 2^16, |rest| < 2^21, r <= 2^16. */
static inline uint32_t pel_smooth_root(uint32_t n)
{
    const uint32_t x = n >> 16;
    uint32_t r = ((uint32_t)pel_smooth_first_guess[(n >> 25) - 32] + 128) << 8;
    const int32_t e = (int32_t)((UINT32_C(1) << 30) - (x * r >> 16) * r);
    r += (uint32_t)((e >> 15) * (int32_t)r >> 16);
    const uint32_t q = x * r >> 15;
    const int32_t rest = (int32_t)(n - q * q);
    return (q << 10) + (uint32_t)((rest >> 4) * (int32_t)(r >> 2) >> 16);
}

/* How far from one axis a circle of less than 256 px is at a distance from the
 * other. */
static PEL_INLINE_LOOP PEL_UNUSED int32_t
pel_smooth_width_at(const struct pel_smooth_circle *circle, int32_t distance)
{
    const uint32_t r = (uint32_t)circle->radius, d = (uint32_t)distance;
    int32_t shift = 2;
    if (distance >= circle->radius)
        return 0;
    uint32_t n = r * r - d * d;
    for (; n < UINT32_C(1) << 30; n <<= 2)
        shift++;
    return (int32_t)(pel_smooth_root(n) >> shift);
}

/* From 40 px on l is what a piece has along the axis that the strip's arc goes
 * along, times r / z, z the distance from the centre along the other one, at
 * the middle of the strip: at least .69 r. */
static inline bool pel_smooth_is_steep(const struct pel_smooth_strip *s)
{
    return s->at_near - s->at_far < s->far - s->near;
}

/* (r / z)^3 / 12 r, 2^-23 px, by twice z: the area of a piece that goes along
 * the axis for a pixel, below .006 px. With z = (1 - e) r, 4/3 (1 - e)^-3 is a
 * polynomial that is off by 2.3 %, and the middle of the strip for that of the
 * piece by 5 %, where r is 40 px: together by .1 of 255. The factors are below
 * 2^14 2^8, 2^8 2^11, 2^9 2^8. */
static inline uint32_t pel_smooth_pixel_bulge(const struct pel_smooth_circle *c,
                                              uint32_t z)
{
    const uint32_t e =
        (((uint32_t)c->radius - (z >> 9)) >> c->down) * c->of.inverse >> 8;
    const uint32_t p = 173 + ((169 + (19 * e >> 6)) * e >> 11);
    return p * c->of.inverse >> c->down;
}

/* Of a piece that goes along it for w, at most 2^16: below 2^16 2^15. */
static inline uint32_t pel_smooth_large_bulge(uint32_t pixel, int32_t w)
{
    const uint32_t half = (uint32_t)w >> 1, square = half * half >> 15;
    return pixel * (square * half >> 15) >> 23;
}

#endif
