#include "paint_dither.h"
#include "paint_dither_565.h"

#include "../smooth/smooth.h"

#define OPAQUE UINT32_C(0xFF000000)

/* A channel of n bits has 2^n - 1 steps from level to level: of 255 / (2^n - 1)
 * or, 255 mod (2^n - 1) of them, one more. At a place whose number in the Bayer
 * matrix is m, 0..63, a channel shows the next level when it is k beyond its
 * own and 128 k > (2 m + 1) step: when k > floor((2 m + 1) step / 128). With
 * the threshold 255 less these floors of all steps, every channel c shows level
 *
 *     floor(((2^n - 1) c + threshold) / 256).
 */
#define STEPS(n) ((1 << (n)) - 1)
#define FLOORS(m, step) ((2 * (m) + 1) * (step) / 128)
#define THRESHOLD(n, m)                                              \
    (255 - (STEPS(n) - 255 % STEPS(n)) * FLOORS(m, 255 / STEPS(n)) - \
     255 % STEPS(n) * FLOORS(m, 255 / STEPS(n) + 1))
#define PLACES(of, n, m)                                              \
    of(n, (m) ^ 0), of(n, (m) ^ 32), of(n, (m) ^ 8), of(n, (m) ^ 40), \
        of(n, (m) ^ 2), of(n, (m) ^ 34), of(n, (m) ^ 10), of(n, (m) ^ 42)
#define DEPTHS(m)                                             \
    {                                                         \
        PLACES(THRESHOLD, 1, m), PLACES(THRESHOLD, 2, m),     \
            PLACES(THRESHOLD, 3, m), PLACES(THRESHOLD, 4, m), \
            PLACES(THRESHOLD, 5, m), PLACES(THRESHOLD, 6, m), \
            PLACES(THRESHOLD, 7, m)                           \
    }
#define STEPS565(n, m)                             \
    {                                              \
        THRESHOLD(5, m) * 0x10001, THRESHOLD(n, m) \
    }
#define TWICE(m)                                       \
    {                                                  \
        PLACES(STEPS565, 6, m), PLACES(STEPS565, 6, m) \
    }
#define ROWS(of) of(0), of(48), of(12), of(60), of(3), of(51), of(15), of(63)

static const pel_thresholds thresholds[PEL_PLACES] = {ROWS(DEPTHS)};

/* For struct pel_row565: eight places from any of the first eight on. */
static const struct pel_steps565 thresholds565[PEL_PLACES][2 * PEL_PLACES] = {
    ROWS(TWICE)};

/* Those of n bits in row y, from a place on. */
static inline const uint8_t *places_of(uint32_t n, int32_t y, int32_t x)
{
    return &thresholds[y & 7][x & 7] + (n - 1) * PEL_PLACES;
}

/* At a time; one where stack is short. */
enum { OUT_PIXELS = PEL_SMALL_CODE ? 1 : PEL_AT_A_TIME(8, 1) };

/* The source draws into this surface, whose format passes on what it is given
 * to the target's, dithered; surface.pixels points to the target. */
struct proxy {
    struct pel_surface surface; /* first */
    struct pel_spans spans;     /* on it */
};

static const struct pel_surface *target_of(const struct pel_surface *surface)
{
    return surface->pixels;
}

/* A channel of n bits; `place` is among those of one. Of opaque colors the
 * upper bits count, unless they are weighed after it. */
static inline uint32_t dithered(uint32_t c, uint32_t n, const uint8_t *place,
                                bool opaque)
{
    const uint32_t threshold = place[(n - 1) * PEL_PLACES];
    const uint32_t level = ((c << n) - c + threshold) >> 8;
    return opaque ? level << (8 - n) : pel_widen(level, (int)n);
}

static PEL_STEP pel_color dithered_color(pel_color color,
                                         const struct pel_surface *target,
                                         int32_t x, int32_t y)
{
    const uint8_t *const depth = pel_smooth_depth(target);
    const uint8_t *const place = places_of(1, y, x);
    const bool opaque = color >= OPAQUE && !pel_is_smooth(target);
    uint32_t out = pel_alpha(color);
    if (depth[1] == 0)
        return out << 24 |
               0x010101u * dithered(pel_gray(color), depth[0], place, opaque);
    for (int k = 0; k < 3; k++) {
        color <<= 8;
        out = out << 8 | dithered(color >> 24, depth[k], place, opaque);
    }
    return out;
}

/* n >= 1 pixels, each like the one eight before, which is `bits` bytes away. */
static PEL_STEP void repeat_pixels(const struct pel_surface *target, int32_t x,
                                   int32_t y, int32_t n)
{
    const int32_t bits = target->format->bits;
    uint8_t *p = (uint8_t *)pel_address(target, x, y, bits / 8);
    if (!PEL_SMALL_CODE && bits == 16)
        pel_pattern16((pel_word16 *)(void *)p, n);
    else
        for (n *= bits / 8; n > 0; n--, p++)
            *p = p[-bits];
}

/* 5-6-5 bits have loops of their own. */
static inline bool is_565(const struct pel_format *format)
{
    return !PEL_SMALL_CODE && (format->id == PEL_FORMAT_RGB565_LE ||
                               format->id == PEL_FORMAT_RGB565_BE);
}

static bool is_swapped(const struct pel_format *format)
{
    return (format->id == PEL_FORMAT_RGB565_BE) == (PEL_LE16(1) == 1);
}

static PEL_HOT struct pel_row565 row565_of(const struct pel_surface *target,
                                           int32_t x, int32_t y, int32_t n)
{
    pel_word16 *const p = pel_address16(target, x, y);
    const struct pel_row565 row = {p, p + n, thresholds565[y & 7],
                                   places_of(5, y, 0), (uint32_t)x & 7};
    return row;
}

static PEL_ALWAYS_INLINE void fill_rows(const struct pel_spans *spans,
                                        pel_color color, bool swapped)
{
    const struct pel_surface *const s = target_of(spans->surface);
    const struct pel_steps565 steps = pel_steps565_of(color);
    const struct pel_span *span = spans->span;
    int32_t y = spans->y;
    for (int32_t i = spans->n; i > 0; i--, span++, y += spans->step)
        if (span->x0 < span->x1)
            pel_row565_fill(row565_of(s, span->x0, y, span->x1 - span->x0),
                            steps, swapped);
}

/* False: there is no loop for the format. */
static PEL_STEP_OR_INLINE bool fill_quickly(const struct pel_spans *spans,
                                            pel_color color)
{
    const struct pel_surface *const target = target_of(spans->surface);
    const struct pel_format *const format = target->format;
    const bool quick = is_565(format);
    if (quick && is_swapped(format))
        fill_rows(spans, color, true);
    else if (quick)
        fill_rows(spans, color, false);
    else if (format->channels && format->channels->fill)
        format->channels->fill(target, spans, color, thresholds);
    else
        return false;
    return true;
}

static bool fill_planes(const struct pel_surface *surface, int32_t x, int32_t y,
                        int32_t n, const struct pel_planes *planes)
{
    const struct pel_surface *const target = target_of(surface);
    if (!is_565(target->format))
        return false;
    const struct pel_row565 row = row565_of(target, x, y, n);
    if (is_swapped(target->format))
        pel_row565_planes(row, planes, true);
    else
        pel_row565_planes(row, planes, false);
    return true;
}

static bool fill_walk(const struct pel_surface *surface, int32_t x, int32_t y,
                      int32_t n, const struct pel_walk *walk)
{
    const struct pel_surface *const target = target_of(surface);
    if (!is_565(target->format))
        return false;
    const struct pel_row565 row = row565_of(target, x, y, n);
    if (is_swapped(target->format))
        pel_row565_walk(row, walk, true);
    else
        pel_row565_walk(row, walk, false);
    return true;
}

/* The opaque ones that come first. */
static int32_t put_opaque(const struct pel_surface *target, int32_t x,
                          int32_t y, int32_t n, const pel_color *colors)
{
    const struct pel_span span = {x, x + n};
    const struct pel_spans one = {target, &span, y, 1, 0};
    const struct pel_channels *const channels = target->format->channels;
    if (!PEL_SMALL_CODE && channels && channels->put)
        return channels->put(target, &one, colors, thresholds);
    if (!is_565(target->format))
        return 0;
    const struct pel_row565 row = row565_of(target, x, y, n);
    return is_swapped(target->format) ? pel_row565_put(row, colors, true)
                                      : pel_row565_put(row, colors, false);
}

static void put_colors(const struct pel_surface *surface, int32_t x, int32_t y,
                       int32_t n, const pel_color *colors)
{
    const struct pel_surface *const target = target_of(surface);
    for (int32_t done; n > 0; x += done, n -= done, colors += done) {
        pel_color out[OUT_PIXELS];
        done = put_opaque(target, x, y, n, colors);
        if (done != 0)
            continue;
        for (; done < pel_min(n, OUT_PIXELS); done++)
            out[done] = dithered_color(colors[done], target, x + done, y);
        target->format->put(target, x, y, done, out);
    }
}

/* One color of any alpha. Little is kept over the calls, to spare stack. */
static void fill_color(const struct pel_spans *spans, pel_color color)
{
    const struct pel_span *span = spans->span;
    int32_t y = spans->y;
    for (; span < spans->span + spans->n; span++, y += spans->step)
        for (int32_t x = span->x0, n; x < span->x1; x += n) {
            const struct pel_surface *const target = target_of(spans->surface);
            pel_color out[OUT_PIXELS];
            n = span->x1 - x;
            if (x - span->x0 == PEL_PLACES && color >= OPAQUE) {
                repeat_pixels(target, x, y, n);
                break;
            }
            n = pel_min(n, OUT_PIXELS);
            for (int32_t i = 0; i < n; i++)
                out[i] = dithered_color(color, target, x + i, y);
            target->format->put(target, x, y, n, out);
        }
}

static void fill_opaque(const struct pel_spans *spans, pel_color color)
{
    if (!fill_quickly(spans, color))
        fill_color(spans, color);
}

static void load_colors(const struct pel_surface *surface, int32_t x, int32_t y,
                        int32_t n, pel_color *colors)
{
    const struct pel_surface *target = target_of(surface);
    target->format->load(target, x, y, n, colors);
}

static uint32_t keep(uint32_t color)
{
    return color | OPAQUE;
}

static const struct pel_channels proxy_channels = {
    .planes = fill_planes, .walk = fill_walk, .target = target_of};

static const struct pel_format proxy_format = {
    .id = 255,
    .bits = 32,
    .word = 4,
    .pack = keep,
    .unpack = keep,
    .fill = fill_opaque,
    .blend = fill_color,
    .put = put_colors,
    .load = load_colors,
    .channels = PEL_SMALL_CODE ? NULL : &proxy_channels,
};

static void fill(const struct pel_paint *paint, const struct pel_spans *spans);

/* What the source is to color; NULL: it is a dither itself. A function of its
 * own, to spare the stack of the source. */
static PEL_NOINLINE_32 const struct pel_spans *spans_of(
    struct proxy *proxy, const struct pel_dither *paint,
    const struct pel_spans *spans)
{
    const struct pel_paint *const source = paint->source;
    PEL_ASSERT(source->fill != fill);
    if (source->fill == fill)
        return NULL;
    if (pel_smooth_depth(spans->surface)[0] == 0)
        return spans;
    proxy->surface = *spans->surface;
    proxy->surface.format = &proxy_format;
    proxy->surface.pixels = (void *)spans->surface;
    proxy->spans = *spans;
    proxy->spans.surface = &proxy->surface;
    return &proxy->spans;
}

static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    const struct pel_dither *const dither = (const void *)paint;
    struct proxy proxy;
    spans = spans_of(&proxy, dither, spans);
    if (spans)
        dither->source->fill(dither->source, spans);
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
