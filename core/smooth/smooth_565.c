#include "smooth_565.h"

#include "../format/word.h"

/* What is mixed into pixels. */
struct ink {
    uint32_t red_blue, green, alpha;
};

/* Red and blue in one word, of 16 bits each: products of both at once. Per
 * channel 255 times the mix, rounded as pel_round_div255 does. */
static PEL_ALWAYS_INLINE uint32_t mixed(uint32_t below, uint32_t weight,
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

/* n pixels: where the coverage ends. */
static PEL_ALWAYS_INLINE const uint8_t *mix_run(uintptr_t at,
                                                const uint8_t *coverage,
                                                int32_t n, struct ink ink,
                                                bool big)
{
    pel_word16 *p = (pel_word16 *)at;
    for (const uint8_t *const end = coverage + n; coverage < end; p++) {
        uint32_t weight = *coverage++;
        if (ink.alpha != 255)
            weight = pel_round_div255(weight * ink.alpha);
        *p = (pel_word16)in_order(
            mixed(in_order(*p, big), weight, ink.red_blue, ink.green), big);
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

/* The same in one loop. */
static PEL_ALWAYS_INLINE void mix_runs(const struct pel_surface *s,
                                       const struct pel_smooth_runs *runs,
                                       struct ink ink, bool big)
{
    const uint8_t *coverage = runs->coverage;
    uintptr_t line = pel_column_zero(s, runs->y, 2);
    for (int32_t i = 0; i < 2 * runs->n; i++) {
        const int32_t n = runs->count[i], back = i & 1 ? 0 : n;
        coverage = mix_run(line + 2 * (uintptr_t)(runs->x[i] - back), coverage,
                           n, ink, big);
        if (i & 1)
            line += (uintptr_t)(ptrdiff_t)(s->stride * runs->step);
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

void pel_smooth_mix_565(const struct pel_surface *s,
                        const struct pel_smooth_runs *runs, pel_color color)
{
    const bool big = s->format->id == PEL_FORMAT_RGB565_BE;
    const struct ink ink = ink_of(color, s->format);
    const struct ink opaque = {ink.red_blue, ink.green, 255};
    if (ink.alpha != 255)
        mix_runs(s, runs, ink, big);
    else if (big)
        mix_rows(s, runs, opaque, true);
    else
        mix_rows(s, runs, opaque, false);
}
