/* One color over spans of 32-bit pixels, of any format: channels are bytes, in
 * any order. Only where PEL_VECTORS is 1. */
#ifndef PEL_FORMAT_BLEND32_H
#define PEL_FORMAT_BLEND32_H

#include "vector.h"

#if PEL_VECTORS

/* The color as the bytes of two pixels, 16 bits each. A byte d of the picture
 * becomes (d * rest + source) / 255, rounded (pel_divide255_u16x8). */
struct pel_blend32 {
    pel_u16x8 sources; /* byte of the color * alpha + 128 */
    pel_u16x8 rests;   /* 255 - alpha */
};

/* The bytes of a pixel, twice. */
static inline pel_u16x8 pel_blend32_lanes(uint32_t pixel)
{
    const pel_u32x4 two = {pixel, pixel}, zero = {0};
    return (pel_u16x8)pel_zip_low_u8x16((pel_u8x16)two, (pel_u8x16)zero);
}

static inline struct pel_blend32 pel_blend32_make(
    const struct pel_format *format, pel_color color)
{
    const uint16_t alpha = (uint16_t)pel_alpha(color);
    const uint16_t rest = (uint16_t)(255 - alpha);
    /* The X byte becomes 255 whatever is in memory: (0 d + 255 255) / 255. */
    const pel_u16x8 x = pel_blend32_lanes(format->pack(0));
    const pel_u16x8 source = pel_blend32_lanes(format->pack(color));
    const struct pel_blend32 b = {source * alpha + x * rest + 128, ~x & rest};
    return b;
}

/* Four pixels. */
static inline pel_u16x8 pel_blend32_mix(pel_u16x8 d,
                                        const struct pel_blend32 *b)
{
    const pel_u8x16 bytes = (pel_u8x16)d, zero = {0};
    const pel_u16x8 low = (pel_u16x8)pel_zip_low_u8x16(bytes, zero);
    const pel_u16x8 high = (pel_u16x8)pel_zip_high_u8x16(bytes, zero);
    return (pel_u16x8)pel_join_u8x16(
        pel_divide255_u16x8(low * b->rests + b->sources),
        pel_divide255_u16x8(high * b->rests + b->sources));
}

/* Fewer than 4 pixels: blends the first, the middle and the last one, of which
 * some may be the same. With n <= 0 it blends a variable that nobody reads, as
 * pel_span32_short does. */
static inline void pel_blend32_short(pel_word32 *p, int32_t n,
                                     const struct pel_blend32 *b)
{
    pel_word32 unused = 0;
    pel_word32 *q = n > 0 ? p : &unused;
    const int32_t last = n > 0 ? n - 1 : 0, middle = last >> 1;
    pel_u32x4 v = {q[0], q[middle], q[last], 0};
    v = (pel_u32x4)pel_blend32_mix((pel_u16x8)v, b);
    q[0] = v[0];
    q[middle] = v[1];
    q[last] = v[2];
}

/* More than 8 pixels, by eights. The last eight may overlap those before them:
 * they are read before the first store, and stored last. */
static PEL_ALWAYS_INLINE void pel_blend32_long(pel_word32 *p, int32_t n,
                                               const struct pel_blend32 *b,
                                               uintptr_t ahead)
{
    pel_word32 *end = p + n - 8;
    pel_u16x8 tail = pel_blend32_mix(pel_get_u16x8(end), b);
    pel_u16x8 last = pel_blend32_mix(pel_get_u16x8(end + 4), b);
    do {
        pel_prefetch((uintptr_t)p + ahead);
        pel_u16x8 first = pel_get_u16x8(p), second = pel_get_u16x8(p + 4);
        pel_put_u16x8(p, pel_blend32_mix(first, b));
        pel_put_u16x8(p + 4, pel_blend32_mix(second, b));
        p += 8;
    } while (p < end);
    pel_put_u16x8(end, tail);
    pel_put_u16x8(end + 4, last);
}

/* `ahead`: bytes to the span a few rows below, which is prefetched. */
static PEL_ALWAYS_INLINE void pel_blend32_span(pel_word32 *p, int32_t n,
                                               const struct pel_blend32 *b,
                                               uintptr_t ahead)
{
    if (n < 4) {
        pel_blend32_short(p, n, b);
    } else if (n <= 8) {
        pel_word32 *end = p + n - 4;
        pel_u16x8 tail = pel_blend32_mix(pel_get_u16x8(end), b);
        pel_put_u16x8(p, pel_blend32_mix(pel_get_u16x8(p), b));
        pel_put_u16x8(end, tail);
    } else {
        pel_blend32_long(p, n, b, ahead);
    }
}

#endif
#endif
