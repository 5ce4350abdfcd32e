#include "paint_blend.h"

#include "../smooth/smooth.h"

/* At a time; fewer where stack is short. */
enum {
    COLORS = PEL_SMALL_CODE      ? 1
             : PEL_FEW_REGISTERS ? PEL_AT_A_TIME(16, 4)
                                 : PEL_AT_A_TIME(16, 8)
};

/* The source draws into this surface, whose format combines what it is given
 * with what is on the target. surface.pixels points to the target, and `out` is
 * shared by all functions: both spare stack. */
struct proxy {
    struct pel_surface surface; /* first */
    enum pel_blend_mode mode;
    struct pel_spans spans; /* on it */
    pel_color out[COLORS];
};

static struct proxy *proxy_of(const struct pel_surface *surface)
{
    return (struct proxy *)(void *)surface;
}

static const struct pel_surface *target_of(const struct pel_surface *surface)
{
    return surface->pixels;
}

static uint32_t channel_of(enum pel_blend_mode mode, uint32_t d, uint32_t s)
{
    if (mode == PEL_BLEND_ADD)
        return d + s > 255 ? 255 : d + s;
    return pel_round_div255(d * s);
}

static PEL_ALWAYS_INLINE pel_color combined(enum pel_blend_mode mode,
                                            pel_color d, pel_color s)
{
    pel_color out = pel_alpha(s) << 24;
    for (int shift = 0; shift < 24; shift += 8)
        out |= channel_of(mode, d >> shift & 255, s >> shift & 255) << shift;
    return out;
}

static void load(const struct pel_surface *surface, int32_t x, int32_t y,
                 int32_t n, pel_color *colors)
{
    const struct pel_surface *const target = target_of(surface);
    target->format->load(target, x, y, n, colors);
}

/* At most n pixels, whose colors are brought to `out`: how many. */
static PEL_ALWAYS_INLINE int32_t load_out(const struct pel_surface *surface,
                                          int32_t x, int32_t y, int32_t n)
{
    const struct pel_surface *const target =
        pel_smooth_target(target_of(surface));
    n = pel_min(n, COLORS);
    target->format->load(target, x, y, n, proxy_of(surface)->out);
    return n;
}

/* Combines the first n of `out` with colors, `next` from each to the next. */
static PEL_NOINLINE_32 void combine_out(struct proxy *proxy, int32_t n,
                                        const pel_color *colors, int32_t next)
{
    const enum pel_blend_mode mode = proxy->mode;
    pel_color *out = proxy->out;
    for (; mode == PEL_BLEND_XOR && n > 0; n--, colors += next, out++)
        *out = (*out & UINT32_C(0xFFFFFF)) ^ *colors;
    for (; n > 0; n--, colors += next, out++)
        *out = combined(mode, *out, *colors);
}

static PEL_ALWAYS_INLINE void put_out(const struct pel_surface *surface,
                                      int32_t x, int32_t y, int32_t n)
{
    const struct pel_surface *const target = target_of(surface);
    target->format->put(target, x, y, n, proxy_of(surface)->out);
}

static void put(const struct pel_surface *surface, int32_t x, int32_t y,
                int32_t n, const pel_color *colors)
{
    for (int32_t done; n > 0; x += done, n -= done, colors += done) {
        done = load_out(surface, x, y, n);
        combine_out(proxy_of(surface), done, colors, 1);
        put_out(surface, x, y, done);
    }
}

/* y, or the same anew: where registers are few it is not kept over calls. */
static inline int32_t row_of(const struct pel_spans *spans,
                             const struct pel_span *span, int32_t y)
{
    return PEL_SHORT_STACK && PEL_FEW_REGISTERS
               ? spans->y + (int32_t)(span - spans->span) * spans->step
               : y;
}

/* Little is kept over the calls, to spare stack. */
static void fill_color(const struct pel_spans *spans, pel_color color)
{
    const struct pel_span *span = spans->span;
    int32_t y = spans->y;
    for (; span < spans->span + spans->n; span++, y += spans->step)
        for (int32_t x = span->x0; x < span->x1;) {
            const int32_t n = load_out(spans->surface, x,
                                       row_of(spans, span, y), span->x1 - x);
            combine_out(proxy_of(spans->surface), n, &color, 0);
            put_out(spans->surface, x, row_of(spans, span, y), n);
            x += n;
        }
}

static uint32_t keep(uint32_t color)
{
    return color | UINT32_C(0xFF000000);
}

static const struct pel_format proxy_format = {.id = 252,
                                               .bits = 32,
                                               .word = 4,
                                               .pack = keep,
                                               .unpack = keep,
                                               .fill = fill_color,
                                               .blend = fill_color,
                                               .put = put,
                                               .load = load};

/* A function of its own, to spare the stack of the source. */
static PEL_NOINLINE_32 void make_proxy(struct proxy *proxy,
                                       const struct pel_spans *spans,
                                       enum pel_blend_mode mode)
{
    proxy->surface = *spans->surface;
    proxy->surface.format = &proxy_format;
    proxy->surface.pixels = (void *)spans->surface;
    proxy->mode = mode;
    proxy->spans = *spans;
    proxy->spans.surface = &proxy->surface;
}

static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    const struct pel_blend *const p = (const void *)paint;
    struct proxy proxy;
    const bool legal =
        spans->surface->format->load && spans->surface->format->put;
    PEL_ASSERT(legal);
    if (!legal)
        return;
    make_proxy(&proxy, spans, p->mode);
    p->source->fill(p->source, &proxy.spans);
}

enum pel_status pel_blend_init(struct pel_blend *paint,
                               const struct pel_paint *source,
                               enum pel_blend_mode mode)
{
    if (paint)
        pel_paint_clear(&paint->paint);
    if (!paint || !source)
        return PEL_ERROR_NULL;
    if (source == &paint->paint || (unsigned)mode > PEL_BLEND_MULTIPLY)
        return PEL_ERROR_RANGE;
    paint->paint = (struct pel_paint){fill, NULL};
    paint->source = source;
    paint->mode = mode;
    return PEL_OK;
}
