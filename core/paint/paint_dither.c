#include "paint_dither.h"

#include "../format/word.h"
#include "../raster/edge.h"

/* The Bayer matrix: 0..63, each once. */
static const uint8_t matrix[8][8] = {
    {0, 32, 8, 40, 2, 34, 10, 42},  {48, 16, 56, 24, 50, 18, 58, 26},
    {12, 44, 4, 36, 14, 46, 6, 38}, {60, 28, 52, 20, 62, 30, 54, 22},
    {3, 35, 11, 43, 1, 33, 9, 41},  {51, 19, 59, 27, 49, 17, 57, 25},
    {15, 47, 7, 39, 13, 45, 5, 37}, {63, 31, 55, 23, 61, 29, 53, 21},
};

/* The source draws into this surface, whose format passes on what it is given
 * to the target's, dithered. */
struct proxy {
    struct pel_surface surface;
    const struct pel_surface *target;
};

static const struct pel_surface *target_of(const struct pel_surface *proxy)
{
    return ((const struct proxy *)(const void *)proxy)->target;
}

/* A channel between two levels: the low one, how far to the high one, and how
 * much of that it has gone, times 128. */
struct channel {
    uint32_t low, step, gone;
};

/* 8 bits from fewer, which are the upper ones, repeated: what the format shows.
 */
static inline uint32_t widened(uint32_t top, uint32_t bits)
{
    uint32_t c = top | top >> bits;
    if (bits < 4) {
        c |= c >> 2 * bits;
        c |= c >> 4 * bits;
    }
    return c;
}

/* The level below the lowest of all is not asked for: 0 is a level. */
static PEL_ALWAYS_INLINE struct channel channel_of(uint32_t c, uint32_t bits)
{
    const uint32_t unit = 256u >> bits;
    uint32_t top = c & (0u - unit), low = widened(top, bits);
    if (low > c) {
        top -= unit;
        low = widened(top, bits);
    }
    if (low == c)
        return (struct channel){c, 0, 0};
    return (struct channel){low, widened(top + unit, bits) - low,
                            (c - low) * 128};
}

/* Its value at a place of the matrix: the high level where it has gone more
 * than 2 m + 1 of 128. */
static PEL_INLINE_LOOP uint32_t dithered_channel(uint32_t c, uint32_t bits,
                                                 uint32_t m)
{
    const struct channel v = channel_of(c, bits);
    return v.gone > (2 * m + 1) * v.step ? v.low + v.step : v.low;
}

static PEL_INLINE_LOOP pel_color dithered(const uint8_t depth[3],
                                          pel_color color, uint32_t m)
{
    const pel_color alpha = color & UINT32_C(0xFF000000);
    if (depth[1] == 0)
        return alpha |
               dithered_channel(pel_gray(color), depth[0], m) * 0x010101u;
    return alpha | dithered_channel(pel_red(color), depth[0], m) << 16 |
           dithered_channel(pel_green(color), depth[1], m) << 8 |
           dithered_channel(pel_blue(color), depth[2], m);
}

/* One opaque colour: its pixel value where every channel is low, the bits that
 * change where one is high, and how many places of the matrix that are. */
struct levels {
    uint32_t pixel, change[3];
    uint8_t places[3];
};

/* gone > (2 m + 1) step holds for (gone - 1) / step / 2, rounded up, m. */
static uint32_t places_of(const struct channel *v)
{
    int32_t rest;
    if (v->gone == 0)
        return 0;
    return (uint32_t)(pel_floor_divide((int32_t)v->gone - 1, (int32_t)v->step,
                                       &rest) +
                      1) /
           2;
}

static PEL_NOINLINE void levels_of(const struct pel_format *format,
                                   pel_color color, struct levels *l)
{
    const uint8_t *depth = format->dithering->depth;
    const bool gray = depth[1] == 0;
    const pel_color c = gray ? pel_gray(color) * 0x010101u : color;
    pel_color low = 0, high[3];
    for (int k = 0; k < 3; k++) {
        const struct channel v =
            channel_of(c >> (16 - 8 * k) & 255, depth[gray ? 0 : k]);
        low |= v.low << (16 - 8 * k);
        high[k] = v.step * (gray ? 0x010101u : 0x010000u >> 8 * k);
        l->places[k] = (uint8_t)(gray && k ? 0 : places_of(&v));
    }
    l->pixel = format->pack(low);
    for (int k = 0; k < 3; k++)
        l->change[k] = l->pixel ^ format->pack(low + high[k]);
}

/* The pixel values of a row's columns [x, end), which go on repeating; on
 * 64-bit CPUs all eight. */
static PEL_INLINE_LOOP void row_pattern(const struct levels *l, int32_t x,
                                        int32_t end, const uint8_t row[8],
                                        uint32_t pattern[8])
{
    const uint32_t change0 = l->change[0], places0 = l->places[0];
    const uint32_t change1 = l->change[1], places1 = l->places[1];
    const uint32_t change2 = l->change[2], places2 = l->places[2];
    const int32_t n = PEL_64BIT ? 8 : pel_min(end - x, 8);
    for (int32_t i = 0; i < n; i++) {
        const int32_t at = PEL_64BIT ? i : (x + i) & 7;
        const uint32_t m = row[at];
        pattern[at] = l->pixel ^ (m < places0 ? change0 : 0) ^
                      (m < places1 ? change1 : 0) ^ (m < places2 ? change2 : 0);
    }
}

static void fill_color(const struct pel_spans *spans, uint32_t color)
{
    const struct pel_surface *target = target_of(spans->surface);
    struct levels levels;
    uint32_t pattern[8];
    int32_t y = spans->y;
    void (*const own)(const struct pel_surface *, int32_t, int32_t, int32_t,
                      const uint32_t *) = target->format->dithering->pattern;
    levels_of(target->format, color, &levels);
    for (int32_t i = 0; i < spans->n; i++, y += spans->step) {
        const struct pel_span *span = &spans->span[i];
        if (span->x0 >= span->x1)
            continue;
        row_pattern(&levels, span->x0, span->x1, matrix[y & 7], pattern);
        (own ? own : pel_pattern16)(target, span->x0, y, span->x1 - span->x0,
                                    pattern);
    }
}

/* At a time; one where stack is short. */
enum { PUT_PIXELS = PEL_KNOW_SIDES ? 8 : 1 };

static void put_colors(const struct pel_surface *surface, int32_t x, int32_t y,
                       int32_t n, const pel_color *colors)
{
    const struct pel_surface *target = target_of(surface);
    const uint8_t *const depth = target->format->dithering->depth;
    const uint8_t *const row = matrix[y & 7];
    pel_color out[PUT_PIXELS];
    while (n > 0) {
        const int32_t count = pel_min(n, PUT_PIXELS);
        for (int32_t i = 0; i < count; i++)
            out[i] = dithered(depth, colors[i], row[(x + i) & 7]);
        target->format->put(target, x, y, count, out);
        x += count;
        n -= count;
        colors += count;
    }
}

static void blend_color(const struct pel_spans *spans, pel_color color)
{
    const struct pel_surface *target = target_of(spans->surface);
    int32_t y = spans->y;
    for (int32_t i = 0; i < spans->n; i++, y += spans->step)
        for (int32_t x = spans->span[i].x0; x < spans->span[i].x1; x++) {
            const pel_color out = dithered(target->format->dithering->depth,
                                           color, matrix[y & 7][x & 7]);
            target->format->put(target, x, y, 1, &out);
        }
}

static void load_colors(const struct pel_surface *surface, int32_t x, int32_t y,
                        int32_t n, pel_color *colors)
{
    const struct pel_surface *target = target_of(surface);
    target->format->load(target, x, y, n, colors);
}

static uint32_t keep(uint32_t color)
{
    return color;
}

static const struct pel_format proxy_format = {
    255,        32,          4,          keep,        keep,
    fill_color, blend_color, put_colors, load_colors, NULL,
};

static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    const struct pel_paint *source = ((const struct pel_dither *)paint)->source;
    PEL_ASSERT(source->fill != fill);
    if (source->fill == fill)
        return;
    if (!spans->surface->format->dithering) {
        source->fill(source, spans);
        return;
    }
    struct proxy proxy;
    struct pel_spans all = *spans;
    proxy.surface = *spans->surface;
    proxy.surface.format = &proxy_format;
    proxy.target = spans->surface;
    all.surface = &proxy.surface;
    source->fill(source, &all);
}

enum pel_status pel_dither_init(struct pel_dither *paint,
                                const struct pel_paint *source)
{
    if (paint)
        pel_paint_clear(&paint->paint);
    if (!paint || !source)
        return PEL_ERROR_NULL;
    if (source == &paint->paint || source->fill == fill)
        return PEL_ERROR_RANGE;
    paint->paint = (struct pel_paint){fill, NULL};
    paint->source = source;
    return PEL_OK;
}
