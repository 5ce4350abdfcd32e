/* Colours: 0xAARRGGBB, 8 bits a channel, straight alpha (255 is opaque). The
 * values are sRGB and are mixed as they are; a mix in linear light would differ
 * by up to 60 steps. */
#ifndef PEL_BASE_COLOR_H
#define PEL_BASE_COLOR_H

#include <stdint.h>

typedef uint32_t pel_color;

#define PEL_RGBA(r, g, b, a)                                             \
    ((pel_color)(a) << 24 | (pel_color)(r) << 16 | (pel_color)(g) << 8 | \
     (pel_color)(b))
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
static inline uint32_t pel_gray(pel_color c)
{
    return (77 * pel_red(c) + 150 * pel_green(c) + 29 * pel_blue(c) + 128) >> 8;
}

/* round(t / 255) for 0 <= t <= 255 * 255, as floor(floor(u 257 / 256) / 256)
 * with u = t + 128: equal to the rounded quotient for every t. */
static inline uint32_t pel_round_div255(uint32_t t)
{
    t += 128;
    return (t + (t >> 8)) >> 8;
}

/* Source over destination with the source's weight a, 0..255, per channel
 * round((s a + d (255 - a)) / 255). The result is opaque: a = 255 gives s,
 * a = 0 gives d. Red and blue share a word: each product sum is at most
 * 255 * 255 + 128 and, with its own high byte added, below 2^16. */
static inline pel_color pel_mix(pel_color d, pel_color s, uint32_t a)
{
    uint32_t rest = 255 - a;
    uint32_t rb =
        (s & 0xFF00FFu) * a + (d & 0xFF00FFu) * rest + UINT32_C(0x800080);
    uint32_t g = pel_green(s) * a + pel_green(d) * rest + 128;
    rb = (rb + (rb >> 8 & 0xFF00FFu)) >> 8 & 0xFF00FFu;
    g = (g + (g >> 8)) & 0xFF00u;
    return UINT32_C(0xFF000000) | rb | g;
}

#endif
