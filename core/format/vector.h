/* 16-byte vectors of GNU C, loaded and stored at any address through memcpy,
 * and the functions of formats that take them. Only where PEL_VECTORS is 1. */
#ifndef PEL_FORMAT_VECTOR_H
#define PEL_FORMAT_VECTOR_H

#include <string.h>

#include "word.h"

/* Blends a color into spans of 32-bit pixels: a format's blend. */
void pel_blend32(const struct pel_spans *spans, pel_color color);

/* The same of the three formats of 5-6-5 bits. */
void pel_blend565(const struct pel_spans *spans, pel_color color);

/* Puts n - n % 8 colors, and returns how many. */
int32_t pel_put565(const struct pel_format *format, pel_word16 *p, int32_t n,
                   const pel_color *colors);

/* Packs n colors, alpha ignored, and what unpacking makes of n pixels. */
void pel_pack565(const struct pel_format *format, pel_word16 *p, int32_t n,
                 const pel_color *colors);
void pel_load565(const struct pel_surface *surface, int32_t x, int32_t y,
                 int32_t n, pel_color *colors);

/* The `put` of xrgb8888 and argb8888, whose pixels are colors. */
void pel_put32(const struct pel_surface *surface, int32_t x, int32_t y,
               int32_t n, const pel_color *colors);

/* Copies pixels, of which it sets the bits `set`. */
void pel_copy32(pel_word32 *to, const pel_word32 *from, int32_t n,
                uint32_t set);

#if PEL_VECTORS

typedef uint32_t pel_u32x4 __attribute__((__vector_size__(16)));
typedef int32_t pel_s32x4 __attribute__((__vector_size__(16)));
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

/* Lanes of two vectors of a type: those of a, then those of b. */
#ifdef __clang__
#define PEL_SHUFFLE(type, a, b, ...) __builtin_shufflevector(a, b, __VA_ARGS__)
#else
#define PEL_SHUFFLE(type, a, b, ...) \
    __builtin_shuffle(a, b, (type){__VA_ARGS__})
#endif

/* Lanes i to l, of 0 to 3 in a and 4 to 7 in b. */
#define PEL_LANES(a, b, i, j, k, l) PEL_SHUFFLE(pel_u32x4, a, b, i, j, k, l)

/* Bytes or halves of words of a and b by turns: the lower lanes of both, the
 * upper ones. */
static inline pel_u8x16 pel_zip_low_u8x16(pel_u8x16 a, pel_u8x16 b)
{
    return PEL_SHUFFLE(pel_u8x16, a, b, 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5,
                       21, 6, 22, 7, 23);
}

static inline pel_u16x8 pel_zip_low_u16x8(pel_u16x8 a, pel_u16x8 b)
{
    return PEL_SHUFFLE(pel_u16x8, a, b, 0, 8, 1, 9, 2, 10, 3, 11);
}

static inline pel_u16x8 pel_zip_high_u16x8(pel_u16x8 a, pel_u16x8 b)
{
    return PEL_SHUFFLE(pel_u16x8, a, b, 4, 12, 5, 13, 6, 14, 7, 15);
}

static inline pel_u8x16 pel_zip_high_u8x16(pel_u8x16 a, pel_u8x16 b)
{
    return PEL_SHUFFLE(pel_u8x16, a, b, 8, 24, 9, 25, 10, 26, 11, 27, 12, 28,
                       13, 29, 14, 30, 15, 31);
}

/* pel_dot_s16: in every lane the sum of the products of the lower and of the
 * upper 16 bits, signed ones.
 * pel_divide255_u16x8: floor(u 257 / 65,536) = floor((u + floor(u / 256)) /
 * 256) in every lane, which pel_round_div255 does after adding 128.
 * pel_narrow_u16x8: eight lanes, all below 65,536, in 16 bits each.
 * pel_join_u8x16: sixteen lanes, all below 256, in 8 bits each.
 * pel_clamp_u8: four signed lanes, clamped to 0..255, as the bytes of a word.
 * pel_cover_of: what the alphas of eight colors are. */
enum pel_cover { PEL_CLEAR, PEL_MIXED, PEL_OPAQUE };

#ifdef __SSE2__
typedef int16_t pel_s16x8 __attribute__((__vector_size__(16)));

static PEL_HOT pel_u32x4 pel_dot_s16(pel_u32x4 a, pel_u32x4 b)
{
    return (pel_u32x4)__builtin_ia32_pmaddwd128((pel_s16x8)a, (pel_s16x8)b);
}

static inline pel_u16x8 pel_divide255_u16x8(pel_u16x8 u)
{
    const pel_s16x8 m = {257, 257, 257, 257, 257, 257, 257, 257};
    return (pel_u16x8)__builtin_ia32_pmulhuw128((pel_s16x8)u, m);
}

/* The instruction narrows signed numbers. */
static inline pel_u16x8 pel_narrow_u16x8(pel_u32x4 low, pel_u32x4 high)
{
    const pel_s32x4 a = (pel_s32x4)(low - 0x8000u);
    const pel_s32x4 b = (pel_s32x4)(high - 0x8000u);
    return (pel_u16x8)__builtin_ia32_packssdw128(a, b) ^ 0x8000;
}

static inline pel_u8x16 pel_join_u8x16(pel_u16x8 low, pel_u16x8 high)
{
    return (pel_u8x16)__builtin_ia32_packuswb128((pel_s16x8)low,
                                                 (pel_s16x8)high);
}

static inline uint32_t pel_clamp_u8(pel_u32x4 v)
{
    const pel_s16x8 halves =
        __builtin_ia32_packssdw128((pel_s32x4)v, (pel_s32x4)v);
    return ((pel_u32x4)__builtin_ia32_packuswb128(halves, halves))[0];
}

static PEL_ALWAYS_INLINE enum pel_cover pel_cover_of(pel_u32x4 a, pel_u32x4 b)
{
    typedef char c8x16 __attribute__((__vector_size__(16)));
    const pel_u8x16 all = (pel_u8x16)(a & b), any = (pel_u8x16)(a | b);
    if ((__builtin_ia32_pmovmskb128((c8x16)(all == 255)) & 0x8888) == 0x8888)
        return PEL_OPAQUE;
    return (__builtin_ia32_pmovmskb128((c8x16)(any != 0)) & 0x8888) == 0
               ? PEL_CLEAR
               : PEL_MIXED;
}

#else
static PEL_HOT pel_u32x4 pel_dot_s16(pel_u32x4 a, pel_u32x4 b)
{
    const pel_s32x4 low =
        ((pel_s32x4)(a << 16) >> 16) * ((pel_s32x4)(b << 16) >> 16);
    const pel_s32x4 high = ((pel_s32x4)a >> 16) * ((pel_s32x4)b >> 16);
    return (pel_u32x4)low + (pel_u32x4)high;
}

static inline pel_u16x8 pel_divide255_u16x8(pel_u16x8 u)
{
    return (u + (u >> 8)) >> 8;
}

static inline pel_u16x8 pel_narrow_u16x8(pel_u32x4 low, pel_u32x4 high)
{
    return PEL_SHUFFLE(pel_u16x8, (pel_u16x8)low, (pel_u16x8)high, 0, 2, 4, 6,
                       8, 10, 12, 14);
}

static inline pel_u8x16 pel_join_u8x16(pel_u16x8 low, pel_u16x8 high)
{
    return PEL_SHUFFLE(pel_u8x16, (pel_u8x16)low, (pel_u8x16)high, 0, 2, 4, 6,
                       8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
}

static inline uint32_t pel_clamp_u8(pel_u32x4 v)
{
    const pel_u32x4 below = (pel_u32x4)((pel_s32x4)v >> 31);
    const pel_u32x4 above = (pel_u32x4)((pel_s32x4)(255 - v) >> 31);
    const pel_u8x16 c = (pel_u8x16)((v | above) & ~below);
    return ((pel_u32x4)PEL_SHUFFLE(pel_u8x16, c, c, 0, 4, 8, 12, 0, 4, 8, 12, 0,
                                   4, 8, 12, 0, 4, 8, 12))[0];
}

static PEL_ALWAYS_INLINE enum pel_cover pel_cover_of(pel_u32x4 a, pel_u32x4 b)
{
    const uint64_t alphas = UINT64_C(0xFF000000FF000000);
    const pel_u32x4 all[2] = {a & b, a | b};
    uint64_t half[4];
    memcpy(half, all, 32);
    if ((~(half[0] & half[1]) & alphas) == 0)
        return PEL_OPAQUE;
    return ((half[2] | half[3]) & alphas) == 0 ? PEL_CLEAR : PEL_MIXED;
}

#endif
#endif
#endif
