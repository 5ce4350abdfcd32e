/* 16-byte vectors of GNU C, loaded and stored at any address through memcpy.
 * Only where PEL_VECTORS is 1. */
#ifndef PEL_FORMAT_VECTOR_H
#define PEL_FORMAT_VECTOR_H

#include <string.h>

#include "word.h"

#if PEL_VECTORS

typedef uint32_t pel_u32x4 __attribute__((__vector_size__(16)));
typedef uint16_t pel_u16x8 __attribute__((__vector_size__(16)));
typedef uint8_t pel_u8x16 __attribute__((__vector_size__(16)));
typedef uint64_t pel_u64x2 __attribute__((__vector_size__(16)));

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

/* Lanes i to l, of 0 to 3 in a and 4 to 7 in b. */
#ifdef __clang__
#define PEL_LANES(a, b, i, j, k, l) __builtin_shufflevector(a, b, i, j, k, l)
#else
#define PEL_LANES(a, b, i, j, k, l) \
    __builtin_shuffle(a, b, (pel_u32x4){i, j, k, l})
#endif

/* Bytes of a and b by turns: the lower eight of both, the upper eight. */
static inline pel_u8x16 pel_zip_low_u8x16(pel_u8x16 a, pel_u8x16 b)
{
#ifdef __clang__
    return __builtin_shufflevector(a, b, 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5,
                                   21, 6, 22, 7, 23);
#else
    return __builtin_shuffle(
        a, b,
        (pel_u8x16){0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23});
#endif
}

static inline pel_u8x16 pel_zip_high_u8x16(pel_u8x16 a, pel_u8x16 b)
{
#ifdef __clang__
    return __builtin_shufflevector(a, b, 8, 24, 9, 25, 10, 26, 11, 27, 12, 28,
                                   13, 29, 14, 30, 15, 31);
#else
    return __builtin_shuffle(a, b,
                             (pel_u8x16){8, 24, 9, 25, 10, 26, 11, 27, 12, 28,
                                         13, 29, 14, 30, 15, 31});
#endif
}

/* In every lane the sum of the products of the lower and of the upper 16 bits,
 * signed ones. */
static inline pel_u32x4 pel_dot_s16(pel_u32x4 a, pel_u32x4 b)
{
#ifdef __SSE2__
    typedef int16_t s16x8 __attribute__((__vector_size__(16)));
    return (pel_u32x4)__builtin_ia32_pmaddwd128((s16x8)a, (s16x8)b);
#else
    typedef int32_t s32x4 __attribute__((__vector_size__(16)));
    const s32x4 low = ((s32x4)(a << 16) >> 16) * ((s32x4)(b << 16) >> 16);
    const s32x4 high = ((s32x4)a >> 16) * ((s32x4)b >> 16);
    return (pel_u32x4)low + (pel_u32x4)high;
#endif
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

/* Sixteen lanes, all below 256, in 8 bits each. */
static inline pel_u8x16 pel_join_u8x16(pel_u16x8 low, pel_u16x8 high)
{
#ifdef __SSE2__
    typedef int16_t s16x8 __attribute__((__vector_size__(16)));
    return (pel_u8x16)__builtin_ia32_packuswb128((s16x8)low, (s16x8)high);
#else
    typedef uint8_t u8x8 __attribute__((__vector_size__(8)));
    const u8x8 both[2] = {__builtin_convertvector(low, u8x8),
                          __builtin_convertvector(high, u8x8)};
    pel_u8x16 v;
    memcpy(&v, both, 16);
    return v;
#endif
}

/* The same of 32 bits. */
static inline pel_u8x16 pel_narrow_u8x16(pel_u32x4 a, pel_u32x4 b, pel_u32x4 c,
                                         pel_u32x4 d)
{
#ifdef __SSE2__
    typedef int32_t s32x4 __attribute__((__vector_size__(16)));
    return pel_join_u8x16(
        (pel_u16x8)__builtin_ia32_packssdw128((s32x4)a, (s32x4)b),
        (pel_u16x8)__builtin_ia32_packssdw128((s32x4)c, (s32x4)d));
#else
    typedef uint8_t u8x4 __attribute__((__vector_size__(4)));
    const u8x4 four[4] = {
        __builtin_convertvector(a, u8x4), __builtin_convertvector(b, u8x4),
        __builtin_convertvector(c, u8x4), __builtin_convertvector(d, u8x4)};
    pel_u8x16 v;
    memcpy(&v, four, 16);
    return v;
#endif
}

#endif
#endif
