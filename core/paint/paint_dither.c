#include "paint_dither.h"

#include <string.h>

/* The Bayer matrix: 0..63, each once. */
static const uint8_t matrix[8][8] = {
    {0, 32, 8, 40, 2, 34, 10, 42},  {48, 16, 56, 24, 50, 18, 58, 26},
    {12, 44, 4, 36, 14, 46, 6, 38}, {60, 28, 52, 20, 62, 30, 54, 22},
    {3, 35, 11, 43, 1, 33, 9, 41},  {51, 19, 59, 27, 49, 17, 57, 25},
    {15, 47, 7, 39, 13, 45, 5, 37}, {63, 31, 55, 23, 61, 29, 53, 21},
};

/* Bits of each channel in the format. */
struct depth {
    uint8_t red, green, blue;
    bool gray; /* of all channels in one: those of red */
};

static struct depth depth_of(const struct pel_format *format)
{
    switch (format->id) {
    case PEL_FORMAT_RGB565_LE:
    case PEL_FORMAT_RGB565_BE:
    case PEL_FORMAT_BGR565_LE:
        return (struct depth){5, 6, 5, false};
    case PEL_FORMAT_XRGB1555_LE:
        return (struct depth){5, 5, 5, false};
    case PEL_FORMAT_RGB332:
        return (struct depth){3, 3, 2, false};
    case PEL_FORMAT_GRAY4:
        return (struct depth){4, 4, 4, true};
    case PEL_FORMAT_MONO1:
    case PEL_FORMAT_MONO1_PAGES:
        return (struct depth){1, 1, 1, true};
    default:
        return (struct depth){8, 8, 8, false};
    }
}

/* 8 bits from fewer, repeated from the top: what the format shows. */
static uint32_t widened(uint32_t level, int bits)
{
    uint32_t c = level << (8 - bits);
    c |= c >> bits;
    c |= c >> 2 * bits;
    return c | c >> 4 * bits;
}

/* c, or one of the levels around it: the higher one when the part of the step
 * that c has gone exceeds threshold / 128. */
static uint32_t dithered(uint32_t c, int bits, uint32_t threshold)
{
    uint32_t level = c >> (8 - bits), low = widened(level, bits);
    if (low > c)
        low = widened(--level, bits);
    if (low == c)
        return c;
    uint32_t high = widened(level + 1, bits);
    return (c - low) * 128 > threshold * (high - low) ? high : low;
}

static pel_color dithered_color(pel_color c, const struct depth *d,
                                uint32_t threshold)
{
    if (d->gray) {
        uint32_t gray = dithered(pel_gray(c), d->red, threshold);
        return PEL_RGBA(gray, gray, gray, pel_alpha(c));
    }
    return PEL_RGBA(dithered(pel_red(c), d->red, threshold),
                    dithered(pel_green(c), d->green, threshold),
                    dithered(pel_blue(c), d->blue, threshold), pel_alpha(c));
}

/* The source draws into a line of colours, in a format of its own that takes
 * them as they are, alpha and all, instead of blending. */

static uint32_t keep(uint32_t color)
{
    return color;
}

static pel_color *color_at(const struct pel_surface *s, int32_t x)
{
    return (pel_color *)s->pixels + (x - s->bounds.x0);
}

static void keep_one(const struct pel_spans *spans, pel_color color)
{
    const struct pel_span *span = spans->span;
    for (int32_t i = spans->n; i > 0; i--, span++)
        for (int32_t x = span->x0; x < span->x1; x++)
            *color_at(spans->surface, x) = color;
}

static void keep_all(const struct pel_surface *s, int32_t x, int32_t y,
                     int32_t n, const pel_color *colors)
{
    (void)y;
    memcpy(color_at(s, x), colors, (size_t)n * sizeof *colors);
}

static void load(const struct pel_surface *s, int32_t x, int32_t y, int32_t n,
                 pel_color *colors)
{
    (void)y;
    memcpy(colors, color_at(s, x), (size_t)n * sizeof *colors);
}

static const struct pel_format kept = {
    255, 32, 4, keep, keep, keep_one, keep_one, keep_all, load,
};

static PEL_NOINLINE void source_colors(const struct pel_paint *source,
                                       int32_t y, const struct pel_span *span,
                                       pel_color *colors)
{
    const struct pel_surface surface = {colors,
                                        4 * (span->x1 - span->x0),
                                        {span->x0, y, span->x1, y + 1},
                                        {span->x0, y, span->x1, y + 1},
                                        &kept};
    const struct pel_spans spans = {&surface, span, y, 1, 1};
    source->fill(source, &spans);
}

/* A power of two, as in paint_colors.c. */
enum { RUN_PIXELS = PEL_FAST_64BIT ? 64 : PEL_KNOW_SIDES ? 16 : 4 };

static PEL_NOINLINE void dither_colors(const struct pel_format *format,
                                       int32_t y, const struct pel_span *part,
                                       pel_color *colors)
{
    const struct depth depth = depth_of(format);
    const uint8_t *thresholds = matrix[y & 7];
    for (int32_t x = part->x0; x < part->x1; x++, colors++)
        *colors = dithered_color(*colors, &depth, 2u * thresholds[x & 7] + 1);
}

static void fill_run(const struct pel_dither *p, const struct pel_spans *spans,
                     int32_t y, const struct pel_span *span)
{
    pel_color colors[RUN_PIXELS];
    struct pel_span part = *span;
    for (; part.x0 < span->x1; part.x0 = part.x1) {
        part.x1 = pel_min(span->x1, (part.x0 | (RUN_PIXELS - 1)) + 1);
        /* What the source does not paint stays transparent. */
        memset(colors, 0, (size_t)(part.x1 - part.x0) * sizeof *colors);
        source_colors(p->source, y, &part, colors);
        dither_colors(spans->surface->format, y, &part, colors);
        pel_put_colors(spans->surface, part.x0, y, part.x1 - part.x0, colors);
    }
}

static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    const struct pel_dither *p = (const void *)paint;
    const struct pel_span *span = spans->span;
    int32_t y = spans->y;
    if (depth_of(spans->surface->format).red == 8) {
        p->source->fill(p->source, spans);
        return;
    }
    for (; span < spans->span + spans->n; span++, y += spans->step)
        fill_run(p, spans, y, span);
}

enum pel_status pel_dither_init(struct pel_dither *paint,
                                const struct pel_paint *source)
{
    if (!paint || !source)
        return PEL_ERROR_NULL;
    paint->paint = (struct pel_paint){fill, NULL};
    paint->source = source;
    return PEL_OK;
}
