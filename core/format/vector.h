/* 16-byte vectors of GNU C, loaded and stored at any address through memcpy.
 * Only where PEL_VECTORS is 1. */
#ifndef PEL_FORMAT_VECTOR_H
#define PEL_FORMAT_VECTOR_H

#include <string.h>

#include "word.h"

#if PEL_VECTORS

typedef uint32_t pel_u32x4 __attribute__((__vector_size__(16)));
typedef uint16_t pel_u16x8 __attribute__((__vector_size__(16)));

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

#endif
#endif
