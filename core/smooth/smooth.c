#include "smooth.h"

#include <string.h>

/* The surface before the surface: its pixels are the colors of a paint, as they
 * are. What is not painted has alpha 0. */
static pel_color *color_at(const struct pel_surface *s, int32_t x)
{
    return (pel_color *)s->pixels + (x - s->bounds.x0);
}

static void put(const struct pel_surface *s, int32_t x, int32_t y, int32_t n,
                const pel_color *colors)
{
    (void)y;
    memcpy(color_at(s, x), colors, (size_t)n * sizeof *colors);
}

static void fill(const struct pel_spans *spans, pel_color color)
{
    const struct pel_span *span = spans->span;
    for (; span < spans->span + spans->n; span++)
        for (int32_t x = span->x0; x < span->x1; x++)
            *color_at(spans->surface, x) = color;
}

static const struct pel_surface *target_of(const struct pel_surface *surface)
{
    return ((const struct pel_smooth *)(const void *)surface)->target;
}

static void load(const struct pel_surface *surface, int32_t x, int32_t y,
                 int32_t n, pel_color *colors)
{
    const struct pel_surface *const target = target_of(surface);
    target->format->load(target, x, y, n, colors);
}

static pel_color same(uint32_t color)
{
    return color;
}

static const struct pel_format color_format = {.id = PEL_SMOOTH_FORMAT,
                                               .bits = 32,
                                               .word = 4,
                                               .pack = same,
                                               .unpack = same,
                                               .fill = fill,
                                               .blend = fill,
                                               .put = put,
                                               .load = load};

static const struct pel_flat *flat_of(const struct pel_paint *paint)
{
    return paint->fill == pel_flat_fill ? (const void *)paint : NULL;
}

bool pel_smooth_begin(struct pel_smooth *smooth,
                      const struct pel_surface *surface,
                      const struct pel_paint *paint)
{
    const bool legal = !surface->format || surface->format->put;
    PEL_ASSERT(legal);
    smooth->surface = *surface;
    smooth->surface.format = &color_format;
    smooth->surface.pixels = smooth->colors;
    smooth->target = surface;
    smooth->paint = paint;
    smooth->flat = flat_of(paint);
    return legal;
}

/* The color with alpha = round(alpha coverage / 255), 257 alpha being given:
 * pel_round_div255 in two steps. */
static inline pel_color weighed(pel_color color, uint32_t alpha,
                                uint32_t coverage)
{
    return (color & UINT32_C(0xFFFFFF)) |
           (alpha * coverage + 0x8080) >> 16 << 24;
}

static PEL_NOINLINE_32 void take_colors(struct pel_smooth *smooth, int32_t x,
                                        int32_t y, int32_t n)
{
    const struct pel_span span = {x, x + n};
    const struct pel_spans spans = {&smooth->surface, &span, y, 1, 0};
    for (int32_t i = 0; i < n; i++)
        smooth->colors[i] = 0;
    smooth->surface.bounds = (struct pel_rect){x, y, x + n, y + 1};
    smooth->paint->fill(smooth->paint, &spans);
}

static inline void weigh_flat(struct pel_smooth *smooth, int32_t n,
                              const uint8_t *coverage)
{
    const pel_color color = smooth->flat->color;
    const uint32_t alpha = 257 * pel_alpha(color);
    for (pel_color *out = smooth->colors; n > 0; n--)
        *out++ = weighed(color, alpha, *coverage++);
}

static inline void weigh_colors(struct pel_smooth *smooth, int32_t n,
                                const uint8_t *coverage)
{
    for (pel_color *out = smooth->colors; n > 0; n--, out++)
        *out = weighed(*out, 257 * pel_alpha(*out), *coverage++);
}

/* At most as many pixels as the buffer has. */
static PEL_HOT void paint_part(struct pel_smooth *smooth, int32_t x, int32_t y,
                               int32_t n, const uint8_t *coverage)
{
    const struct pel_surface *const target = smooth->target;
    if (smooth->flat) {
        weigh_flat(smooth, n, coverage);
    } else {
        take_colors(smooth, x, y, n);
        weigh_colors(smooth, n, coverage);
    }
    if (target->format)
        target->format->put(target, x, y, n, smooth->colors);
}

/* Without the pixels of 0 at both ends. */
static PEL_HOT void paint_edge(struct pel_smooth *smooth, int32_t x, int32_t y,
                               int32_t n, const uint8_t *coverage)
{
    for (; n > 0 && coverage[n - 1] == 0; n--)
        ;
    for (; n > 0 && *coverage == 0; n--, x++)
        coverage++;
    for (int32_t k; n > 0; n -= k, x += k, coverage += k) {
        k = pel_min(n, PEL_SMOOTH_PIXELS);
        paint_part(smooth, x, y, k, coverage);
    }
}

void pel_smooth_paint(struct pel_smooth *smooth,
                      const struct pel_smooth_row *row)
{
    const int32_t full = row->x + row->left;
    const struct pel_span span = {full, full + row->full};
    const struct pel_spans spans = {smooth->target, &span, row->y, 1, 0};
    if (row->full > 0)
        smooth->paint->fill(smooth->paint, &spans);
    paint_edge(smooth, row->x, row->y, row->left, row->coverage);
    paint_edge(smooth, span.x1, row->y, row->right, row->coverage + row->left);
}

/* Takes up to `skip` pixels away: how many. */
static int32_t skip_pixels(int32_t *n, int32_t skip)
{
    skip = pel_max(pel_min(*n, skip), 0);
    *n -= skip;
    return skip;
}

static void cut_right(struct pel_smooth_row *r, int32_t end)
{
    int32_t skip = r->x + r->left + r->full + r->right - end;
    skip -= skip_pixels(&r->right, skip);
    skip -= skip_pixels(&r->full, skip);
    skip_pixels(&r->left, skip);
}

static void cut_left(struct pel_smooth_row *r, int32_t begin)
{
    int32_t skip = pel_max(begin - r->x, 0);
    r->x += skip;
    const int32_t left = skip_pixels(&r->left, skip);
    skip -= left;
    skip -= skip_pixels(&r->full, skip);
    r->coverage += left + skip_pixels(&r->right, skip);
}

void pel_smooth_paint_clipped(struct pel_smooth *smooth,
                              const struct pel_smooth_row *row)
{
    const struct pel_rect *const clip = &smooth->surface.clip;
    struct pel_smooth_row r = *row;
    if (r.y < clip->y0 || r.y >= clip->y1)
        return;
    cut_right(&r, clip->x1);
    cut_left(&r, clip->x0);
    pel_smooth_paint(smooth, &r);
}
