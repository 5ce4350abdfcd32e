/* Blending one color into runs of 5-6-5 pixels, in any of their three orders.
 * Only where PEL_VECTORS is 1. */
#ifndef PEL_FORMAT_BLEND565_H
#define PEL_FORMAT_BLEND565_H

#include "vector.h"
#include "word16.h"

#if PEL_VECTORS

/* Fields from the top of the pixel: high (5 bits), middle (6), low (5); of each
 * source * alpha + 128, for pel_round_div255. */
struct pel_blend565 {
    uint16_t high, middle, low;
    uint16_t rest; /* 255 - alpha */
    bool swapped;  /* the high byte comes first */
};

static inline struct pel_blend565 pel_blend565_make(
    const struct pel_format *format, pel_color color)
{
    const uint32_t alpha = pel_alpha(color);
    const bool bgr = format->id == PEL_FORMAT_BGR565_LE;
    const uint32_t high = bgr ? pel_blue(color) : pel_red(color);
    const uint32_t low = bgr ? pel_red(color) : pel_blue(color);
    struct pel_blend565 b;
    b.high = (uint16_t)(high * alpha + 128);
    b.middle = (uint16_t)(pel_green(color) * alpha + 128);
    b.low = (uint16_t)(low * alpha + 128);
    b.rest = (uint16_t)(255 - alpha);
    b.swapped = format->id == PEL_FORMAT_RGB565_BE;
    return b;
}

/* d is an 8-bit channel, s of a struct pel_blend565. */
static inline uint32_t pel_blend565_mix(uint32_t d, uint32_t s, uint32_t rest)
{
    uint32_t t = d * rest + s;
    return (t + (t >> 8)) >> 8;
}

static inline void pel_blend565_pixel(pel_word16 *p,
                                      const struct pel_blend565 *b)
{
    uint32_t v = b->swapped ? pel_swap16(*p) : *p;
    uint32_t high = pel_blend565_mix(pel_widen(v >> 11, 5), b->high, b->rest);
    uint32_t middle =
        pel_blend565_mix(pel_widen(v >> 5 & 63, 6), b->middle, b->rest);
    uint32_t low = pel_blend565_mix(pel_widen(v & 31, 5), b->low, b->rest);
    v = (high & 0xF8u) << 8 | (middle & 0xFCu) << 3 | low >> 3;
    *p = (pel_word16)(b->swapped ? pel_swap16(v) : v);
}

static inline pel_u16x8 pel_blend565_mixes(pel_u16x8 d, uint16_t s,
                                           uint16_t rest)
{
    return pel_divide255_u16x8(d * rest + s);
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
    high = pel_blend565_mixes(high, b->high, b->rest);
    middle = pel_blend565_mixes(middle, b->middle, b->rest);
    low = pel_blend565_mixes(low, b->low, b->rest);
    v = (high & 0xF8) << 8 | (middle & 0xFC) << 3 | low >> 3;
    return b->swapped ? (v << 8 | v >> 8) : v;
}

/* Fewer than 8 pixels: their first and last four, both read before the first
 * store, so they may overlap; of fewer than 4 each alone. */
static inline void pel_blend565_short(pel_word16 *p, int32_t n,
                                      const struct pel_blend565 *b)
{
    uint16_t ends[8];
    if (n < 4) {
        for (; n > 0; n--)
            pel_blend565_pixel(p++, b);
        return;
    }
    memcpy(ends, p, 8);
    memcpy(ends + 4, p + n - 4, 8);
    pel_put_u16x8(ends, pel_blend565_vector(pel_get_u16x8(ends), b));
    memcpy(p, ends, 8);
    memcpy(p + n - 4, ends + 4, 8);
}

/* As pel_blend32_run. */
static PEL_ALWAYS_INLINE void pel_blend565_run(pel_word16 *p, int32_t n,
                                               const struct pel_blend565 *b)
{
    if (n < 8) {
        pel_blend565_short(p, n, b);
        return;
    }
    pel_word16 *end = p + n - 8;
    pel_u16x8 tail = pel_blend565_vector(pel_get_u16x8(end), b);
    for (; p < end; p += 8)
        pel_put_u16x8(p, pel_blend565_vector(pel_get_u16x8(p), b));
    pel_put_u16x8(end, tail);
}

/* A format's blend, in blend565.c. */
void pel_blend565_rows(const struct pel_spans *spans, pel_color color);

#endif
#endif
