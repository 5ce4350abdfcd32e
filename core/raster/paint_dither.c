#include "paint_dither.h"

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

/* The colours of the source, and whether all are opaque. */
static bool source_colors(const struct pel_paint *source, int32_t x, int32_t y,
                          int32_t n, pel_color *colors)
{
    if (source->fill == pel_flat_fill) {
        const pel_color color = ((const struct pel_flat *)source)->color;
        for (int32_t i = 0; i < n; i++)
            colors[i] = color;
        return pel_alpha(color) == 255;
    }
    const struct pel_color_paint *p = (const void *)source;
    p->colors(p, x, y, n, colors);
    return p->opaque;
}

static void fill_run(const struct pel_dither *p, const struct pel_surface *s,
                     int32_t y, const struct pel_row *row)
{
    pel_color colors[PEL_BUFFER_PIXELS];
    const struct depth depth = depth_of(s->format);
    const uint8_t *thresholds = matrix[y & 7];
    for (int32_t x = row->x0, n; x < row->x1; x += n) {
        n = pel_min(row->x1 - x, PEL_BUFFER_PIXELS);
        bool opaque = source_colors(p->source, x, y, n, colors);
        for (int32_t i = 0; i < n; i++)
            colors[i] = dithered_color(colors[i], &depth,
                                       2u * thresholds[(x + i) & 7] + 1);
        if (opaque)
            s->format->put(s, x, y, n, colors);
        else
            pel_put_colors(s, x, y, n, colors);
    }
}

static void fill(const struct pel_paint *paint, const struct pel_rows *rows)
{
    const struct pel_dither *p = (const void *)paint;
    const struct pel_surface *s = rows->surface;
    int32_t y = rows->y;
    PEL_ASSERT(s->format->put); /* not a fill-only twin */
    if (depth_of(s->format).red == 8) {
        p->source->fill(p->source, rows);
        return;
    }
    for (int i = 0; s->format->put && i < rows->n; i++, y += rows->step)
        fill_run(p, s, y, &rows->row[i]);
}

enum pel_status pel_dither_init(struct pel_dither *paint,
                                const struct pel_paint *source)
{
    if (!paint || !source)
        return PEL_ERROR_NULL;
    if (source->fill != pel_flat_fill && source->fill != pel_color_paint_fill)
        return PEL_ERROR_RANGE;
    paint->paint = (struct pel_paint){.fill = fill};
    paint->source = source;
    return PEL_OK;
}
