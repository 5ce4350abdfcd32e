/* Colors: 0xAARRGGBB, 8 bits a channel, straight alpha (255 is opaque). The
 * values are sRGB and are mixed as they are; a mix in linear light would differ
 * by up to 60 steps. */
#ifndef PEL_BASE_COLOR_H
#define PEL_BASE_COLOR_H

#include <stdint.h>

#include "inline.h"

typedef uint32_t pel_color;

/* Channels are taken modulo 256. */
#define PEL_CHANNEL(c) PEL_CAST(pel_color, (c)&INT64_C(255))
#define PEL_RGBA(r, g, b, a)                                             \
    (PEL_CHANNEL(a) << 24 | PEL_CHANNEL(r) << 16 | PEL_CHANNEL(g) << 8 | \
     PEL_CHANNEL(b))
#define PEL_RGB(r, g, b) PEL_RGBA(r, g, b, 255)

static inline uint32_t pel_alpha(pel_color c)
{
    return c >> 24;
}

static inline uint32_t pel_red(pel_color c)
{
    return c >> 16 & 255;
}

static inline uint32_t pel_green(pel_color c)
{
    return c >> 8 & 255;
}

static inline uint32_t pel_blue(pel_color c)
{
    return c & 255;
}

/* 8-bit grey, rounded: the weights of ITU-R BT.601 in 1/256. */
static PEL_HOT uint32_t pel_luma(uint32_t red, uint32_t green, uint32_t blue)
{
    return (77 * red + 150 * green + 29 * blue + 128) >> 8;
}

static PEL_HOT uint32_t pel_gray(pel_color c)
{
    return pel_luma(pel_red(c), pel_green(c), pel_blue(c));
}

/* round(t / 255), exactly, for 0 <= t <= 255 * 255. */
static inline uint32_t pel_round_div255(uint32_t t)
{
    t += 128;
    return (t + (t >> 8)) >> 8;
}

/* The color with its alpha times weight / 255. */
static inline pel_color pel_weighed(pel_color c, uint32_t weight)
{
    return (c & UINT32_C(0xFFFFFF)) | pel_round_div255(pel_alpha(c) * weight)
                                          << 24;
}

/* A color times its alpha, and the weight of the color below. The factor 257
 * makes a shift of the division: pel_round_div255(t) is 257 (t + 128) >> 16. */
struct pel_premultiplied {
    uint32_t red, green, blue; /* 257 (channel alpha + 128) */
    uint32_t rest;             /* 257 (255 - alpha) */
};

/* Channels are cut out by shifts: a mask would take a register. */
static PEL_ALWAYS_INLINE struct pel_premultiplied pel_premultiply(pel_color c)
{
    const uint32_t alpha = 257 * pel_alpha(c);
    const struct pel_premultiplied s = {
        (c << 8 >> 24) * alpha + 0x8080, (c << 16 >> 24) * alpha + 0x8080,
        (c << 24 >> 24) * alpha + 0x8080, 0xFFFF - alpha};
    return s;
}

/* The upper `bits` of the channel s, premultiplied, over d, 0..255. The sum is
 * below 2^24. */
static inline uint32_t pel_channel_over(uint32_t d, uint32_t s, uint32_t rest,
                                        int bits)
{
    return (d * rest + s) >> (24 - bits);
}

/* The same of all channels: an opaque color. */
static inline pel_color pel_over(pel_color d, const struct pel_premultiplied *s)
{
    return PEL_RGB(pel_channel_over(pel_red(d), s->red, s->rest, 8),
                   pel_channel_over(pel_green(d), s->green, s->rest, 8),
                   pel_channel_over(pel_blue(d), s->blue, s->rest, 8));
}

/* Source over destination, opaque: per channel round((s a + d (255 - a)) / 255)
 * with the weight a, 0..255. */
static PEL_SHARED pel_color pel_mix(pel_color d, pel_color s, uint32_t a)
{
    const struct pel_premultiplied weighed =
        pel_premultiply((s & UINT32_C(0xFFFFFF)) | a << 24);
    return pel_over(d, &weighed);
}

/* Hue, saturation, value to RGB. A turn of hue goes red, yellow, green, cyan,
 * blue, magenta. With F the part of its sixth that a hue has gone, 0 <= F < 1,
 * the channels are v and p = v (1 - s),  q = v (1 - s F),  t = v (1 - s (1 -
 * F)), s and v in [0, 1] given as 0..255, results in 0..255 rounded to the
 * nearest (a tie upwards). */
PEL_BEGIN_DECLS

/* hue in 1/65,536 turns, any: -1 is 65,535. s and v 0..255. Opaque. */
pel_color pel_hsv(int32_t hue, uint32_t s, uint32_t v);

/* hue in degrees, any: 360 is 0, -1 is 359. */
pel_color pel_hsv_degrees(int32_t hue, uint32_t s, uint32_t v);
PEL_END_DECLS

/* round(v (255 turn - s part) / (255 turn)), 0 <= part <= turn <= 65,536, turn
 * even: the sum is below 2^32. To round twice changes nothing: as 255 is odd,
 * the second rounds up from a half, which the first rounds up, too. */
static inline uint32_t pel_hsv_level(uint32_t s, uint32_t v, uint32_t part,
                                     uint32_t turn)
{
    return pel_round_div255((v * (255 * turn - s * part) + turn / 2) / turn);
}

/* The color of a hue that has gone part / turn of the sixth `sixth`, 0..5.
 * Inlined: a constant turn that is a power of two needs no division. */
static inline pel_color pel_hsv_sixth(uint32_t sixth, uint32_t part,
                                      uint32_t turn, uint32_t s, uint32_t v)
{
    static const uint8_t v_shift[6] = {16, 8, 8, 0, 0, 16};
    static const uint8_t between_shift[6] = {8, 16, 0, 8, 16, 0};
    const int top = v_shift[sixth], between = between_shift[sixth];
    return PEL_RGB(0, 0, 0) | v << top |
           pel_hsv_level(s, v, sixth & 1 ? part : turn - part, turn)
               << between |
           pel_hsv_level(s, v, turn, turn) << (24 - between - top);
}
#endif
