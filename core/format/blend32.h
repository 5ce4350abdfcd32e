/* Blending one color into runs of 32-bit pixels. Channels are bytes, so their
 * order does not matter: all four 32-bit formats share this. Only where
 * PEL_VECTORS is 1. */
#ifndef PEL_FORMAT_BLEND32_H
#define PEL_FORMAT_BLEND32_H

#include "vector.h"
#include "word32.h"

#if PEL_VECTORS

/* What a run needs of the color: 16-bit lanes of source * alpha + 128, for
 * pel_round_div255, and of 255 - alpha. */
struct pel_blend32 {
    uint32_t even, odd;       /* of bytes 0 and 2 of a pixel, of 1 and 3 */
    uint32_t rest;            /* 255 - alpha */
    uint32_t x;               /* bits of the X byte, which is stored as 0xFF */
    pel_u16x8 sources, rests; /* of two pixels, byte by byte */
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
    const uint32_t alpha = pel_alpha(color), source = format->pack(color);
    struct pel_blend32 b;
    b.even = (source & 0xFF00FFu) * alpha + 0x800080u;
    b.odd = (source >> 8 & 0xFF00FFu) * alpha + 0x800080u;
    b.rest = 255 - alpha;
    b.x = format->pack(0);
    /* In the lane of the X byte: 255 * 255 + 128, and nothing of memory. */
    const pel_u16x8 x = pel_blend32_lanes(b.x);
    b.sources = pel_blend32_lanes(source) * (uint16_t)alpha +
                x * (uint16_t)b.rest + 128;
    b.rests = ~x & (uint16_t)b.rest;
    return b;
}

static inline void pel_blend32_pixel(pel_word32 *p, const struct pel_blend32 *b)
{
    uint32_t even = (*p & 0xFF00FFu) * b->rest + b->even;
    uint32_t odd = (*p >> 8 & 0xFF00FFu) * b->rest + b->odd;
    even = (even + (even >> 8 & 0xFF00FFu)) >> 8 & 0xFF00FFu;
    odd = (odd + (odd >> 8 & 0xFF00FFu)) & 0xFF00FF00u;
    *p = even | odd | b->x;
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

/* More than 8 pixels by eights, of which the last ends before the run does. The
 * run's last eight pixels are read before the first store, and stored last:
 * they may overlap those before them. */
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

/* `ahead`: bytes to the run that is next but a few, whose cache lines the loop
 * asks for as it goes; a loop of its own would end at a branch of its own. */
static PEL_ALWAYS_INLINE void pel_blend32_run(pel_word32 *p, int32_t n,
                                              const struct pel_blend32 *b,
                                              uintptr_t ahead)
{
    if (n < 4) {
        for (; n > 0; n--)
            pel_blend32_pixel(p++, b);
    } else if (n <= 8) {
        pel_word32 *end = p + n - 4;
        pel_u16x8 tail = pel_blend32_mix(pel_get_u16x8(end), b);
        pel_put_u16x8(p, pel_blend32_mix(pel_get_u16x8(p), b));
        pel_put_u16x8(end, tail);
    } else {
        pel_blend32_long(p, n, b, ahead);
    }
}

/* A format's blend, in blend32.c. */
void pel_blend32_rows(const struct pel_spans *spans, pel_color color);

#endif
#endif
