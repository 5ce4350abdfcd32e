#include "smooth_565.h"

#include "../format/word.h"

/* What is mixed into pixels; in which order the CPU finds their bytes. */
struct ink {
    uint32_t red_blue, green, alpha;
    bool big;
};

/* A loop for each order of bytes, but where code is to be small. */
#ifdef __OPTIMIZE_SIZE__
enum { LOOPS = 1 };
#define MIX static PEL_NOINLINE
#else
enum { LOOPS = 2 };
#define MIX static PEL_ALWAYS_INLINE
#endif

/* Red and blue in one word, of 16 bits each: products of both at once. Per
 * channel 255 times the mix, rounded as pel_round_div255 does. */
static PEL_ALWAYS_INLINE uint32_t mixed(uint32_t below, uint32_t coverage,
                                        uint32_t red_blue, uint32_t green)
{
    const uint32_t rest = 255 - coverage;
    uint32_t rb = (below & 31) | below >> 11 << 16, g = below << 21 >> 26;
    rb = (rb << 3 | (rb >> 2 & 0x70007)) * rest;
    g = (g << 2 | g >> 4) * rest;
    rb += red_blue * coverage + 0x800080;
    g += green * coverage + 0x80;
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
MIX const uint8_t *mix_run(pel_word16 *p, const uint8_t *coverage, int32_t n,
                           const struct ink *ink, bool big)
{
    const uint32_t red_blue = ink->red_blue, green = ink->green;
    for (const uint8_t *const end = coverage + n; coverage < end; p++)
        *p = (pel_word16)in_order(
            mixed(in_order(*p, big), *coverage++, red_blue, green), big);
    return coverage;
}

static void weigh(const uint8_t *coverage, int32_t n, uint32_t alpha,
                  uint8_t *to)
{
    for (int32_t i = 0; i < n; i++)
        to[i] = (uint8_t)pel_round_div255(alpha * coverage[i]);
}

/* With the alpha of the color. */
static PEL_NOINLINE_32 const uint8_t *weigh_run(pel_word16 *p,
                                                const uint8_t *coverage,
                                                int32_t n,
                                                const struct ink *ink)
{
    uint8_t weighed[16];
    for (int32_t k; n > 0; n -= k, p += k, coverage += k) {
        k = pel_min(n, (int32_t)sizeof weighed);
        weigh(coverage, k, ink->alpha, weighed);
        mix_run(p, weighed, k, ink, ink->big);
    }
    return coverage;
}

static PEL_ALWAYS_INLINE const uint8_t *paint_run(pel_word16 *p,
                                                  const uint8_t *coverage,
                                                  int32_t n,
                                                  const struct ink *ink)
{
    if (ink->alpha != 255)
        return weigh_run(p, coverage, n, ink);
    return mix_run(p, coverage, n, ink, ink->big);
}

static inline pel_word16 *at(uintptr_t line, int32_t x)
{
    return (pel_word16 *)(line + 2 * (uintptr_t)x);
}

static PEL_ALWAYS_INLINE void paint_runs(const struct pel_surface *s,
                                         const struct pel_smooth_runs *runs,
                                         const struct ink *ink)
{
    const uint8_t *coverage = runs->coverage, *n = runs->count;
    const int32_t pitch = s->stride * runs->step, *x = runs->x;
    const int32_t *const last = x + 2 * runs->n;
    uintptr_t line = pel_column_zero(s, runs->y, 2);
    for (; x < last; x += 2, n += 2, line += (uintptr_t)(ptrdiff_t)pitch) {
        coverage = paint_run(at(line, x[0] - n[0]), coverage, n[0], ink);
        coverage = paint_run(at(line, x[1]), coverage, n[1], ink);
    }
}

static struct ink ink_of(pel_color color, const struct pel_format *format)
{
    const bool bgr = format->id == PEL_FORMAT_BGR565_LE;
    const uint32_t red_blue = bgr ? pel_red(color) | pel_blue(color) << 16
                                  : color & UINT32_C(0xFF00FF);
    return (struct ink){red_blue, pel_green(color), pel_alpha(color),
                        format->id == PEL_FORMAT_RGB565_BE};
}

void pel_smooth_mix_565(const struct pel_surface *s,
                        const struct pel_smooth_runs *runs, pel_color color)
{
    struct ink ink = ink_of(color, s->format);
    if (LOOPS == 1) {
        paint_runs(s, runs, &ink);
    } else if (ink.big) {
        ink.big = true;
        paint_runs(s, runs, &ink);
    } else {
        ink.big = false;
        paint_runs(s, runs, &ink);
    }
}
