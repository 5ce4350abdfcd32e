/* What ramp_vector_*.c and ramp_lanes.h ask of vectors, beyond format/vector.h.
 */
#ifndef PEL_PAINT_RAMP_VECTOR_LANES_H
#define PEL_PAINT_RAMP_VECTOR_LANES_H

#include "../format/vector.h"

#if PEL_VECTORS

typedef int32_t pel_s32x4 __attribute__((__vector_size__(16)));

/* Eight lanes, all below 32,768, in 16 bits each. */
static inline pel_u16x8 pel_join_u16x8(pel_u32x4 low, pel_u32x4 high)
{
#ifdef __SSE2__
    typedef int32_t s32x4 __attribute__((__vector_size__(16)));
    return (pel_u16x8)__builtin_ia32_packssdw128((s32x4)low, (s32x4)high);
#else
    return pel_narrow_u16x8(low, high);
#endif
}

/* Signed lanes, those below 0 and above 255 brought there. */
static inline pel_u16x8 pel_clamp255_s16x8(pel_u16x8 v)
{
    typedef int16_t s16x8 __attribute__((__vector_size__(16)));
    const s16x8 lanes = (s16x8)v & ~((s16x8)v >> 15);
    return (pel_u16x8)((lanes | (255 - lanes) >> 15) & 255);
}

/* The products of the lower halves of the lanes. */
static inline pel_u64x2 pel_multiply_u64x2(pel_u64x2 a, pel_u64x2 b)
{
#ifdef __SSE2__
    typedef int32_t s32x4 __attribute__((__vector_size__(16)));
    return (pel_u64x2)__builtin_ia32_pmuludq128((s32x4)a, (s32x4)b);
#else
    return (a & 0xFFFFFFFFu) * (b & 0xFFFFFFFFu);
#endif
}

/* a[0] b[0] a[1] b[1] ..., of the lower and of the upper halves. */
#if defined(__clang__) || __GNUC__ >= 12
static inline pel_u16x8 pel_zip_low_u16x8(pel_u16x8 a, pel_u16x8 b)
{
    return __builtin_shufflevector(a, b, 0, 8, 1, 9, 2, 10, 3, 11);
}

static inline pel_u16x8 pel_zip_high_u16x8(pel_u16x8 a, pel_u16x8 b)
{
    return __builtin_shufflevector(a, b, 4, 12, 5, 13, 6, 14, 7, 15);
}
#else
static inline pel_u16x8 pel_zip_low_u16x8(pel_u16x8 a, pel_u16x8 b)
{
    return __builtin_shuffle(a, b, (pel_u16x8){0, 8, 1, 9, 2, 10, 3, 11});
}

static inline pel_u16x8 pel_zip_high_u16x8(pel_u16x8 a, pel_u16x8 b)
{
    return __builtin_shuffle(a, b, (pel_u16x8){4, 12, 5, 13, 6, 14, 7, 15});
}
#endif

#endif
#endif
