/* 16-byte vectors of GNU C, loaded and stored at any address through memcpy.
 * Only where PEL_VECTORS is 1. */
#ifndef PEL_FORMAT_VECTOR_H
#define PEL_FORMAT_VECTOR_H

#include <string.h>

#include "word.h"

#if PEL_VECTORS

typedef uint32_t pel_u32x4 __attribute__((__vector_size__(16)));
typedef uint16_t pel_u16x8 __attribute__((__vector_size__(16)));

static inline pel_u32x4 pel_get_u32x4(const void *p)
{
    pel_u32x4 v;
    memcpy(&v, p, 16);
    return v;
}

static inline void pel_put_u32x4(void *p, pel_u32x4 v)
{
    memcpy(p, &v, 16);
}

static inline pel_u16x8 pel_get_u16x8(const void *p)
{
    pel_u16x8 v;
    memcpy(&v, p, 16);
    return v;
}

static inline void pel_put_u16x8(void *p, pel_u16x8 v)
{
    memcpy(p, &v, 16);
}

/* floor(u 257 / 65,536) = floor((u + floor(u / 256)) / 256) in every lane: what
 * pel_round_div255 does after adding 128. */
static inline pel_u16x8 pel_divide255_u16x8(pel_u16x8 u)
{
#ifdef __SSE2__
    typedef int16_t s16x8 __attribute__((__vector_size__(16)));
    const s16x8 m = {257, 257, 257, 257, 257, 257, 257, 257};
    return (pel_u16x8)__builtin_ia32_pmulhuw128((s16x8)u, m);
#else
    return (u + (u >> 8)) >> 8;
#endif
}

/* Eight lanes, all below 65,536, in 16 bits each. */
static inline pel_u16x8 pel_narrow_u16x8(pel_u32x4 low, pel_u32x4 high)
{
#ifdef __SSE2__
    /* It narrows signed numbers. */
    typedef int32_t s32x4 __attribute__((__vector_size__(16)));
    const s32x4 a = (s32x4)(low - 0x8000u), b = (s32x4)(high - 0x8000u);
    return (pel_u16x8)__builtin_ia32_packssdw128(a, b) ^ 0x8000;
#else
    typedef uint16_t u16x4 __attribute__((__vector_size__(8)));
    const u16x4 a = __builtin_convertvector(low, u16x4);
    const u16x4 b = __builtin_convertvector(high, u16x4);
    pel_u16x8 v;
    memcpy(&v, &a, 8);
    memcpy((uint8_t *)&v + 8, &b, 8);
    return v;
#endif
}

#endif
#endif
