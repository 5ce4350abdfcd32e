#include "smooth.h"

/* Colors that are weighed at a time. */
enum { OUT_PIXELS = PEL_KNOW_SIDES ? 8 : 4 };

static const struct pel_smooth *smooth_of(const struct pel_surface *surface)
{
    return (const struct pel_smooth *)(const void *)surface;
}

static const struct pel_surface *target_of(const struct pel_surface *surface)
{
    return smooth_of(surface)->target;
}

static inline pel_color weighed(pel_color color, uint32_t coverage)
{
    return (color & UINT32_C(0xFFFFFF)) |
           pel_round_div255(pel_alpha(color) * coverage) << 24;
}

/* The coverage of the pixel x, which is left or right. */
static const uint8_t *coverage_of(const struct pel_smooth_row *row, int32_t x)
{
    x -= row->x;
    return x < row->left ? row->left_coverage + x
                         : row->right_coverage + (x - row->left - row->middle);
}

static bool in_middle(const struct pel_smooth_row *row, int32_t x)
{
    x -= row->x + row->left;
    return x >= 0 && x < row->middle;
}

/* Puts n weighed pixels; `next` is from a color to the next: 0 or 1. */
static PEL_NOINLINE void put_weighed(const struct pel_smooth *smooth, int32_t x,
                                     int32_t n, const pel_color *colors,
                                     int32_t next)
{
    const struct pel_surface *const target = smooth->target;
    const struct pel_smooth_row *const row = &smooth->row;
    const bool same = in_middle(row, x);
    const uint8_t *coverage = same ? NULL : coverage_of(row, x);
    pel_color out[OUT_PIXELS];
    for (int32_t k; n > 0; n -= k, x += k) {
        for (k = 0; k < n && k < OUT_PIXELS; k++, colors += next)
            out[k] =
                weighed(*colors, same ? row->middle_coverage : *coverage++);
        target->format->put(target, x, row->y, k, out);
    }
}

static void put(const struct pel_surface *surface, int32_t x, int32_t y,
                int32_t n, const pel_color *colors)
{
    (void)y;
    put_weighed(smooth_of(surface), x, n, colors, 1);
}

/* One color. */
static void fill(const struct pel_spans *spans, pel_color color)
{
    const struct pel_smooth *const smooth = smooth_of(spans->surface);
    const struct pel_span *span = spans->span;
    for (; span < spans->span + spans->n; span++) {
        if (span->x0 >= span->x1)
            continue;
        if (in_middle(&smooth->row, span->x0)) {
            const struct pel_spans one = {smooth->target, span, spans->y, 1, 0};
            pel_fill_color(&one, weighed(color, smooth->row.middle_coverage));
        } else {
            put_weighed(smooth, span->x0, span->x1 - span->x0, &color, 0);
        }
    }
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

static const struct pel_format weighing = {.id = 253,
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
    const bool legal = surface->format->put != NULL;
    PEL_ASSERT(legal);
    smooth->surface = *surface;
    smooth->surface.format = &weighing;
    smooth->target = surface;
    smooth->paint = paint;
    return legal;
}

void pel_smooth_paint(struct pel_smooth *smooth,
                      const struct pel_smooth_row *row)
{
    const int32_t left = row->x + row->left, right = left + row->middle;
    const struct pel_paint *const paint = smooth->paint;
    struct pel_span span[3];
    struct pel_spans spans = {smooth->target, span, row->y, 1, 0};
    smooth->row = *row;
    span[0] = (struct pel_span){left, right};
    if (row->middle > 0 && row->middle_coverage == 255) {
        paint->fill(paint, &spans);
        spans.n = 0;
    } else {
        spans.n = row->middle > 0;
    }
    spans.surface = &smooth->surface;
    if (row->left > 0)
        span[spans.n++] = (struct pel_span){row->x, left};
    if (row->right > 0)
        span[spans.n++] = (struct pel_span){right, right + row->right};
    if (spans.n)
        paint->fill(paint, &spans);
}

/* Takes the first of n pixels away, up to `skip`: how many. */
static int32_t skip_pixels(int32_t *n, int32_t skip)
{
    skip = pel_max(pel_min(*n, skip), 0);
    *n -= skip;
    return skip;
}

void pel_smooth_paint_clipped(struct pel_smooth *smooth,
                              const struct pel_smooth_row *row)
{
    const struct pel_rect *const clip = &smooth->surface.clip;
    struct pel_smooth_row r = *row;
    if (r.y < clip->y0 || r.y >= clip->y1)
        return;
    const int32_t beyond = r.x + r.left + r.middle + r.right - clip->x1;
    int32_t skip = pel_max(clip->x0 - r.x, 0);
    r.x += skip;
    const int32_t left = skip_pixels(&r.left, skip);
    r.left_coverage += left;
    skip -= left;
    skip -= skip_pixels(&r.middle, skip);
    r.right_coverage += skip_pixels(&r.right, skip);
    skip = beyond;
    skip -= skip_pixels(&r.right, skip);
    skip -= skip_pixels(&r.middle, skip);
    skip_pixels(&r.left, skip);
    pel_smooth_paint(smooth, &r);
}

void pel_smooth_end(struct pel_smooth *smooth)
{
    (void)smooth;
}
