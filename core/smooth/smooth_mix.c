#include "smooth_mix.h"

#include "../format/word.h"

#if !PEL_SMOOTH_TINY

static PEL_ALWAYS_INLINE uint32_t weight_of(uint32_t alpha, uint32_t coverage)
{
    return alpha == 255 ? coverage : pel_round_div255(alpha * coverage);
}

/* What is mixed into pixels. */
struct ink {
    uint32_t red_blue, green, alpha;
};

/* A pixel of 5-6-5 bits, mixed: red and blue are in the halves of one word, for
 * products of both at once. Of each channel 255 times the mix is made, and
 * divided as pel_round_div255 does. */
static PEL_ALWAYS_INLINE uint32_t mixed_565(uint32_t below, uint32_t weight,
                                            uint32_t red_blue, uint32_t green)
{
    const uint32_t rest = 255 - weight;
    uint32_t rb = (below & 31) | below >> 11 << 16, g = below << 21 >> 26;
    rb = (rb << 3 | (rb >> 2 & 0x70007)) * rest;
    g = (g << 2 | g >> 4) * rest;
    rb += red_blue * weight + 0x800080;
    g += green * weight + 0x80;
    rb += rb >> 8 & 0xFF00FF;
    g += g >> 8;
    return rb >> 27 << 11 | g >> 10 << 5 | rb << 16 >> 27;
}

/* A pixel's value from memory, and back. */
static PEL_ALWAYS_INLINE uint32_t in_order(uint32_t v, bool big)
{
    return big ? PEL_BE16(v) : PEL_LE16(v);
}

/* Mixes into n pixels, and returns where their coverage ends. */
static PEL_ALWAYS_INLINE const uint8_t *mix_run(uintptr_t at,
                                                const uint8_t *coverage,
                                                int32_t n, struct ink ink,
                                                bool big)
{
    pel_word16 *p = (pel_word16 *)at;
    for (const uint8_t *const end = coverage + n; coverage < end; p++) {
        const uint32_t weight = weight_of(ink.alpha, *coverage++);
        *p = (pel_word16)in_order(
            mixed_565(in_order(*p, big), weight, ink.red_blue, ink.green), big);
    }
    return coverage;
}

static PEL_ALWAYS_INLINE void mix_rows(const struct pel_surface *s,
                                       const struct pel_smooth_runs *runs,
                                       struct ink ink, bool big)
{
    const uint8_t *coverage = runs->coverage, *n = runs->count;
    const int32_t pitch = s->stride * runs->step, *x = runs->x;
    const int32_t *const last = x + 2 * runs->n;
    uintptr_t line = pel_column_zero(s, runs->y, 2);
    for (; x < last; x += 2, n += 2, line += (uintptr_t)(ptrdiff_t)pitch) {
        coverage = mix_run(line + 2 * (uintptr_t)(x[0] - n[0]), coverage, n[0],
                           ink, big);
        coverage =
            mix_run(line + 2 * (uintptr_t)x[1], coverage, n[1], ink, big);
    }
}

static struct ink ink_of(pel_color color, const struct pel_format *format)
{
    struct ink ink = {color & UINT32_C(0xFF00FF), pel_green(color),
                      pel_alpha(color)};
    if (format->id == PEL_FORMAT_BGR565_LE)
        ink.red_blue = pel_red(color) | pel_blue(color) << 16;
    return ink;
}

/* Bytes 0, 2, 1 and 3 of a word, in 16 bits each. */
static PEL_ALWAYS_INLINE uint64_t spread(uint32_t v)
{
    return (v | (uint64_t)v << 24) & UINT64_C(0xFF00FF00FF00FF);
}

static PEL_ALWAYS_INLINE uint32_t mixed_64(uint32_t below, uint32_t weight,
                                           uint32_t above)
{
    uint64_t v = spread(below) * (255 - weight) + spread(above) * weight;
    v += UINT64_C(0x80008000800080);
    v += v >> 8 & UINT64_C(0xFF00FF00FF00FF);
    return ((uint32_t)(v >> 8) & UINT32_C(0xFF00FF)) |
           ((uint32_t)(v >> 32) & UINT32_C(0xFF00FF00));
}

/* A word of four bytes, mixed two at once, or all. */
static PEL_ALWAYS_INLINE uint32_t mixed_32(uint32_t below, uint32_t weight,
                                           uint32_t above)
{
    const uint32_t m = UINT32_C(0xFF00FF), rest = 255 - weight;
    if (PEL_64BIT)
        return mixed_64(below, weight, above);
    uint32_t even = (below & m) * rest + (above & m) * weight + 0x800080;
    uint32_t odd =
        (below >> 8 & m) * rest + (above >> 8 & m) * weight + 0x800080;
    even += even >> 8 & m;
    odd += odd >> 8 & m;
    return (even >> 8 & m) | (odd & ~m);
}

/* The bits that are no color are set, but where the weight is 0. */
static PEL_NOINLINE void mix_words(const struct pel_surface *s,
                                   const struct pel_smooth_runs *runs,
                                   pel_color color)
{
    const uint32_t pixel = s->format->pack(color), unused = s->format->pack(0);
    const uint32_t alpha = pel_alpha(color);
    const uint8_t *coverage = runs->coverage;
    uintptr_t line = pel_column_zero(s, runs->y, 4);
    for (int32_t i = 0; i < 2 * runs->n; i++) {
        const int32_t n = runs->count[i], back = i & 1 ? 0 : n;
        pel_word32 *p =
            (pel_word32 *)(line + 4 * (uintptr_t)(runs->x[i] - back));
        for (const uint8_t *const end = coverage + n; coverage < end; p++) {
            const uint32_t weight = weight_of(alpha, *coverage++);
            if (weight > 0)
                *p = mixed_32(*p, weight, pixel) | unused;
        }
        if (i & 1)
            line += (uintptr_t)(ptrdiff_t)(s->stride * runs->step);
    }
}

static PEL_NOINLINE void mix_alpha(const struct pel_surface *s,
                                   const struct pel_smooth_runs *runs,
                                   pel_color color)
{
    mix_rows(s, runs, ink_of(color, s->format),
             s->format->id == PEL_FORMAT_RGB565_BE);
}

void pel_smooth_mix(const struct pel_surface *s,
                    const struct pel_smooth_runs *runs, pel_color color)
{
    if (s->format->bits == 32) {
        mix_words(s, runs, color);
        return;
    }
    if (pel_alpha(color) != 255) {
        mix_alpha(s, runs, color);
        return;
    }
    struct ink ink = ink_of(color, s->format);
    ink.alpha = 255;
    if (s->format->id == PEL_FORMAT_RGB565_BE)
        mix_rows(s, runs, ink, true);
    else
        mix_rows(s, runs, ink, false);
}

static PEL_ALWAYS_INLINE void mix_colors(uintptr_t at, int32_t n,
                                         const pel_color *colors,
                                         const uint8_t *coverage, bool big)
{
    pel_word16 *p = (pel_word16 *)at;
    for (pel_word16 *const end = p + n; p < end; p++) {
        const pel_color color = *colors++;
        const uint32_t weight = weight_of(pel_alpha(color), *coverage++);
        *p = (pel_word16)in_order(mixed_565(in_order(*p, big), weight,
                                            color & UINT32_C(0xFF00FF),
                                            pel_green(color)),
                                  big);
    }
}

static void mix_little(uintptr_t at, int32_t n, const pel_color *colors,
                       const uint8_t *coverage)
{
    mix_colors(at, n, colors, coverage, false);
}

static void mix_big(uintptr_t at, int32_t n, const pel_color *colors,
                    const uint8_t *coverage)
{
    mix_colors(at, n, colors, coverage, true);
}

static void mix_32(uintptr_t at, int32_t n, const pel_color *colors,
                   const uint8_t *coverage)
{
    pel_word32 *p = (pel_word32 *)at;
    for (pel_word32 *const end = p + n; p < end; p++) {
        const pel_color color = *colors++;
        const uint32_t weight = weight_of(pel_alpha(color), *coverage++);
        if (weight > 0)
            *p = PEL_LE32(mixed_32(PEL_LE32(*p), weight, color) |
                          UINT32_C(0xFF000000));
    }
}

pel_smooth_mixer *pel_smooth_mixer_of(const struct pel_format *format)
{
    if (format->id == PEL_FORMAT_XRGB8888)
        return mix_32;
    if (format->id == PEL_FORMAT_RGB565_LE)
        return mix_little;
    return format->id == PEL_FORMAT_RGB565_BE ? mix_big : NULL;
}

#endif
