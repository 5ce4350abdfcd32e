#include "paint_dither.h"

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

/* 8 bits from fewer, repeated from the top: what the format shows. */
static uint32_t widened(uint32_t level, int bits)
{
    uint32_t c = level << (8 - bits);
    c |= c >> bits;
    c |= c >> 2 * bits;
    return c | c >> 4 * bits;
}

static struct channel channel_of(uint32_t c, int bits)
{
    uint32_t level = c >> (8 - bits), low = widened(level, bits);
    if (low > c)
        low = widened(--level, bits);
    if (low == c)
        return (struct channel){c, 0, 0};
    return (struct channel){low, widened(level + 1, bits) - low,
                            (c - low) * 128};
}

/* Does it take the high level at 2 m + 1 of 128, m of the matrix? */
static inline bool is_high(const struct channel *c, uint32_t m)
{
    return c->gone > (2 * m + 1) * c->step;
}

/* Its colour at a place of the matrix. */
static pel_color dithered(const struct pel_format *format, pel_color color,
                          uint32_t m)
{
    pel_color c = pel_alpha(color);
    if (format->dithering->depth[1] == 0) {
        const struct channel gray =
            channel_of(pel_gray(color), format->dithering->depth[0]);
        return c << 24 |
               (gray.low + (is_high(&gray, m) ? gray.step : 0)) * 0x010101u;
    }
    for (int k = 0; k < 3; k++) {
        const struct channel v = channel_of(color >> (16 - 8 * k) & 255,
                                            format->dithering->depth[k]);
        c = c << 8 | (v.low + (is_high(&v, m) ? v.step : 0));
    }
    return c;
}

/* One opaque colour: its pixel value where every channel is low, and the bits
 * that change where one is high. */
struct levels {
    uint32_t pixel, change[3];
    struct channel channel[3];
};

static void levels_of(const struct pel_format *format, pel_color color,
                      struct levels *l)
{
    const bool gray = format->dithering->depth[1] == 0;
    const uint32_t unit = gray ? 0x010101u : 0x010000u;
    pel_color low = 0;
    for (int k = 0; k < 3; k++) {
        const uint32_t c = gray ? pel_gray(color) : color >> (16 - 8 * k) & 255;
        const int bits = format->dithering->depth[gray ? 0 : k];
        l->channel[k] = channel_of(c, bits);
        low = low << 8 | l->channel[k].low;
        if (gray && k)
            l->channel[k].gone = 0;
    }
    l->pixel = format->pack(low);
    for (int k = 0; k < 3; k++)
        l->change[k] =
            l->pixel ^ format->pack(low + (l->channel[k].step * unit >> 8 * k));
}

/* The pixel values of a row's columns [x, end), which go on repeating. */
static void row_pattern(const struct levels *l, int32_t x, int32_t end,
                        const uint8_t thresholds[8], uint32_t pattern[8])
{
    for (end = pel_min(end, x + 8); x < end; x++) {
        const uint32_t m = thresholds[x & 7];
        uint32_t pixel = l->pixel;
        for (int k = 0; k < 3; k++)
            if (is_high(&l->channel[k], m))
                pixel ^= l->change[k];
        pattern[x & 7] = pixel;
    }
}

static void fill_color(const struct pel_spans *spans, uint32_t color)
{
    const struct pel_surface *target = target_of(spans->surface);
    struct levels levels;
    uint32_t pattern[8];
    int32_t y = spans->y;
    levels_of(target->format, color, &levels);
    for (int32_t i = 0; i < spans->n; i++, y += spans->step) {
        const struct pel_span *span = &spans->span[i];
        if (span->x0 >= span->x1)
            continue;
        row_pattern(&levels, span->x0, span->x1, matrix[y & 7], pattern);
        target->format->dithering->pattern(target, span->x0, y,
                                           span->x1 - span->x0, pattern);
    }
}

static void put_colors(const struct pel_surface *surface, int32_t x, int32_t y,
                       int32_t n, const pel_color *colors)
{
    const struct pel_surface *target = target_of(surface);
    pel_color out[8];
    while (n > 0) {
        const int32_t count = pel_min(n, 8);
        for (int32_t i = 0; i < count; i++)
            out[i] =
                dithered(target->format, colors[i], matrix[y & 7][(x + i) & 7]);
        target->format->put(target, x, y, count, out);
        x += count;
        n -= count;
        colors += count;
    }
}

static void blend_color(const struct pel_spans *spans, pel_color color)
{
    int32_t y = spans->y;
    for (int32_t i = 0; i < spans->n; i++, y += spans->step)
        for (int32_t x = spans->span[i].x0; x < spans->span[i].x1; x++)
            put_colors(spans->surface, x, y, 1, &color);
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
    struct proxy proxy = {*spans->surface, spans->surface};
    const struct pel_spans all = {&proxy.surface, spans->span, spans->y,
                                  spans->n, spans->step};
    proxy.surface.format = &proxy_format;
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
