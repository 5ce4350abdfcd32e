#include "smooth.h"

#include "smooth_565.h"

/* Colors that are weighed at a time. */
enum { COLORS = PEL_64BIT ? 64 : PEL_SMALL_CODE ? 4 : 8 };

/* A surface before the surface: its pixels are the colors of a paint, as they
 * are. What is not painted has alpha 0. */
static pel_color *color_at(const struct pel_surface *s, int32_t x)
{
    return (pel_color *)s->pixels + (x - s->bounds.x0);
}

static void put(const struct pel_surface *s, int32_t x, int32_t y, int32_t n,
                const pel_color *colors)
{
    (void)y;
    for (pel_color *at = color_at(s, x); n > 0; n--)
        *at++ = *colors++;
}

static void fill(const struct pel_spans *spans, pel_color color)
{
    const struct pel_span *span = spans->span;
    for (; span < spans->span + spans->n; span++)
        for (int32_t x = span->x0; x < span->x1; x++)
            *color_at(spans->surface, x) = color;
}

static void load(const struct pel_surface *surface, int32_t x, int32_t y,
                 int32_t n, pel_color *colors)
{
    const struct pel_surface *const target =
        ((const struct pel_smooth_surface *)(const void *)surface)->target;
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

bool pel_smooth_begin(struct pel_smooth *smooth,
                      const struct pel_surface *surface,
                      const struct pel_paint *paint)
{
    const bool legal = !surface->format || surface->format->put;
    PEL_ASSERT(legal);
    *smooth = (struct pel_smooth){surface, paint};
    return legal;
}

/* Into colors that are 0. */
static void take_colors(const struct pel_smooth *smooth, int32_t x, int32_t y,
                        int32_t n, pel_color *colors)
{
    struct pel_smooth_surface buffer = {*smooth->target, smooth->target};
    const struct pel_span span = {x, x + n};
    const struct pel_spans spans = {&buffer.surface, &span, y, 1, 0};
    buffer.surface.format = &color_format;
    buffer.surface.pixels = colors;
    buffer.surface.bounds = (struct pel_rect){x, y, x + n, y + 1};
    smooth->paint->fill(smooth->paint, &spans);
}

/* The paint, if it is one color; or NULL. */
static const struct pel_flat *flat_of(const struct pel_paint *paint)
{
    return paint->fill == pel_flat_fill ? (const void *)paint : NULL;
}

/* Sets alpha = round(alpha coverage / 255). */
static inline void weigh(pel_color *colors, int32_t n, const uint8_t *coverage)
{
    for (; n > 0; n--, colors++)
        *colors = (*colors & UINT32_C(0xFFFFFF)) |
                  pel_round_div255(pel_alpha(*colors) * *coverage++) << 24;
}

static void set_colors(pel_color *colors, int32_t n, pel_color color)
{
    for (; n > 0; n--)
        *colors++ = color;
}

/* At most as many pixels as the buffer has. */
static void paint_part(const struct pel_smooth *smooth, int32_t x, int32_t y,
                       int32_t n, const uint8_t *coverage)
{
    const struct pel_flat *const flat = flat_of(smooth->paint);
    const struct pel_surface *const target = smooth->target;
    pel_color colors[COLORS];
    set_colors(colors, n, flat ? flat->color : 0);
    if (!flat)
        take_colors(smooth, x, y, n, colors);
    weigh(colors, n, coverage);
    if (target->format)
        target->format->put(target, x, y, n, colors);
}

/* Without the pixels of 0 at both ends. */
static PEL_NOINLINE_32 void paint_run(const struct pel_smooth *smooth,
                                      int32_t x, int32_t y, int32_t n,
                                      const uint8_t *coverage)
{
    for (; n > 0 && coverage[n - 1] == 0; n--)
        ;
    for (; n > 0 && *coverage == 0; n--, x++)
        coverage++;
    for (int32_t k; n > 0; n -= k, x += k, coverage += k) {
        k = pel_min(n, COLORS);
        paint_part(smooth, x, y, k, coverage);
    }
}

static bool has_pixels(const struct pel_span *span, int32_t n)
{
    while (n > 0 && span->x0 >= span->x1) {
        span++;
        n--;
    }
    return n > 0;
}

/* The full pixels of n rows. */
static PEL_NOINLINE_32 void paint_full(const struct pel_smooth *smooth,
                                       int32_t y, int32_t n,
                                       const struct pel_span *full)
{
    const struct pel_spans spans = {smooth->target, full, y, n, 1};
    if (has_pixels(full, n))
        smooth->paint->fill(smooth->paint, &spans);
}

#if !PEL_SMOOTH_TINY
static void paint_runs(const struct pel_smooth *smooth,
                       const struct pel_smooth_runs *runs)
{
    const struct pel_flat *const flat = flat_of(smooth->paint);
    const uint8_t *coverage = runs->coverage;
    int32_t y = runs->y;
    if (flat && pel_smooth_is_565(smooth->target)) {
        pel_smooth_mix_565(smooth->target, runs, flat->color);
        return;
    }
    for (int32_t i = 0; i < 2 * runs->n; i++) {
        const int32_t n = runs->count[i];
        paint_run(smooth, runs->x[i] - (i & 1 ? 0 : n), y, n, coverage);
        coverage += n;
        y += i & 1 ? runs->step : 0;
    }
}

static void paint_bytes(const struct pel_smooth *smooth,
                        const struct pel_smooth_batch *b, int32_t y,
                        int32_t step)
{
    const struct pel_smooth_runs runs = {y,       step,     b->n,
                                         b->at.x, b->count, b->coverage};
    paint_runs(smooth, &runs);
}

void pel_smooth_paint_batch(const struct pel_smooth *smooth,
                            const struct pel_smooth_batch *b)
{
    paint_full(smooth, b->y, b->n, b->at.full);
    paint_bytes(smooth, b, b->y, 1);
}

static void turn_over(struct pel_span *span, int32_t n)
{
    for (int32_t i = 0; i < --n; i++) {
        const struct pel_span other = span[i];
        span[i] = span[n];
        span[n] = other;
    }
}

void pel_smooth_paint_upwards(const struct pel_smooth *smooth,
                              struct pel_smooth_batch *b, int32_t y)
{
    turn_over(b->at.full, b->n);
    paint_full(smooth, y - b->n + 1, b->n, b->at.full);
    turn_over(b->at.full, b->n);
    paint_bytes(smooth, b, y, -1);
}
#endif

void pel_smooth_paint(const struct pel_smooth *smooth,
                      const struct pel_smooth_row *row)
{
    const int32_t full = row->x + row->left, end = full + row->full;
    const struct pel_span span = {full, end};
    paint_full(smooth, row->y, 1, &span);
#if PEL_SMOOTH_TINY
    paint_run(smooth, row->x, row->y, row->left, row->coverage);
    paint_run(smooth, end, row->y, row->right, row->coverage + row->left);
#else
    const uint8_t count[2] = {(uint8_t)row->left, (uint8_t)row->right};
    const struct pel_smooth_runs runs = {row->y,   1,     1,
                                         &span.x0, count, row->coverage};
    paint_runs(smooth, &runs);
#endif
}

#if PEL_SMOOTH_TINY
void pel_smooth_paint_batch(const struct pel_smooth *smooth,
                            const struct pel_smooth_batch *b)
{
    const struct pel_span *const full = b->at.full;
    const struct pel_smooth_row row = {b->y,        full->x0 - b->count[0],
                                       b->count[0], full->x1 - full->x0,
                                       b->count[1], b->coverage};
    if (b->n > 0)
        pel_smooth_paint(smooth, &row);
}
#endif

void pel_smooth_clip_batch(struct pel_smooth_batch *b,
                           const struct pel_rect *clip)
{
    const uint8_t *from = b->coverage;
    uint8_t *to = b->coverage;
    for (int32_t i = 0; i < 2 * b->n; i++) {
        int32_t n = b->count[i], x = b->at.x[i] - (i & 1 ? 0 : n);
        b->count[i] = 0;
        b->at.x[i] = pel_max(clip->x0, pel_min(b->at.x[i], clip->x1));
        for (; n > 0; n--, x++, from++)
            if (x >= clip->x0 && x < clip->x1) {
                *to++ = *from;
                b->count[i]++;
            }
    }
}
