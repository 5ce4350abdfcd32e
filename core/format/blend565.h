/* Blending one color into spans of 5-6-5 pixels, in any of their three orders.
 * Only where PEL_VECTORS is 1. */
#ifndef PEL_FORMAT_BLEND565_H
#define PEL_FORMAT_BLEND565_H

#include "vector.h"

#if PEL_VECTORS

/* Fields from the top of the pixel: high (5 bits), middle (6), low (5); of each
 * source * alpha + 128, for pel_divide255_u16x8, in eight lanes. */
struct pel_blend565 {
    pel_u16x8 high, middle, low;
    pel_u16x8 rest; /* 255 - alpha */
    bool swapped;   /* the high byte comes first */
};

static inline pel_u16x8 pel_blend565_lanes(uint32_t v)
{
    return (pel_u16x8){0} + (uint16_t)v;
}

static inline struct pel_blend565 pel_blend565_make(
    const struct pel_format *format, pel_color color)
{
    const uint32_t alpha = pel_alpha(color);
    const bool bgr = format->id == PEL_FORMAT_BGR565_LE;
    const uint32_t high = bgr ? pel_blue(color) : pel_red(color);
    const uint32_t low = bgr ? pel_red(color) : pel_blue(color);
    struct pel_blend565 b;
    b.high = pel_blend565_lanes(high * alpha + 128);
    b.middle = pel_blend565_lanes(pel_green(color) * alpha + 128);
    b.low = pel_blend565_lanes(low * alpha + 128);
    b.rest = pel_blend565_lanes(255 - alpha);
    b.swapped = format->id == PEL_FORMAT_RGB565_BE;
    return b;
}

/* Eight pixels. */
static inline pel_u16x8 pel_blend565_vector(pel_u16x8 v,
                                            const struct pel_blend565 *b)
{
    if (b->swapped)
        v = v << 8 | v >> 8;
    pel_u16x8 high = (v >> 8 & 0xF8) | v >> 13;
    pel_u16x8 middle = (v >> 3 & 0xFC) | (v >> 9 & 0x03);
    pel_u16x8 low = (v << 3 & 0xF8) | (v >> 2 & 0x07);
    high = pel_divide255_u16x8(high * b->rest + b->high);
    middle = pel_divide255_u16x8(middle * b->rest + b->middle);
    low = pel_divide255_u16x8(low * b->rest + b->low);
    v = (high & 0xF8) << 8 | (middle & 0xFC) << 3 | low >> 3;
    return b->swapped ? (v << 8 | v >> 8) : v;
}

/* As pel_blend32_short. */
static inline void pel_blend565_short(pel_word16 *p, int32_t n,
                                      const struct pel_blend565 *b)
{
    pel_word16 unused = 0;
    pel_word16 *q = n > 0 ? p : &unused;
    const int32_t last = n > 0 ? n - 1 : 0, middle = last >> 1;
    const uint64_t pixels =
        q[0] | (uint64_t)q[middle] << 16 | (uint64_t)q[last] << 32;
    pel_u64x2 v = {pixels, 0};
    v = (pel_u64x2)pel_blend565_vector((pel_u16x8)v, b);
    q[0] = (pel_word16)v[0];
    q[middle] = (pel_word16)(v[0] >> 16);
    q[last] = (pel_word16)(v[0] >> 32);
}

/* 4 to 7 pixels: their first and last four, both read before the first store,
 * so they may overlap. */
static inline void pel_blend565_ends(pel_word16 *p, int32_t n,
                                     const struct pel_blend565 *b)
{
    uint64_t first, last;
    memcpy(&first, p, 8);
    memcpy(&last, p + n - 4, 8);
    pel_u64x2 v = {first, last};
    v = (pel_u64x2)pel_blend565_vector((pel_u16x8)v, b);
    first = v[0];
    last = v[1];
    memcpy(p, &first, 8);
    memcpy(p + n - 4, &last, 8);
}

/* As pel_blend32_span. */
static PEL_ALWAYS_INLINE void pel_blend565_span(pel_word16 *p, int32_t n,
                                                const struct pel_blend565 *b)
{
    if (n < 4) {
        pel_blend565_short(p, n, b);
        return;
    }
    if (n < 8) {
        pel_blend565_ends(p, n, b);
        return;
    }
    pel_word16 *end = p + n - 8;
    pel_u16x8 tail = pel_blend565_vector(pel_get_u16x8(end), b);
    for (; p < end; p += 8)
        pel_put_u16x8(p, pel_blend565_vector(pel_get_u16x8(p), b));
    pel_put_u16x8(end, tail);
}

#endif
#endif
