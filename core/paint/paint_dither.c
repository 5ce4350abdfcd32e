#include "paint_dither.h"

#include "../format/word.h"

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
#define PLACES(n, m)                                                           \
    THRESHOLD(n, (m) ^ 0), THRESHOLD(n, (m) ^ 32), THRESHOLD(n, (m) ^ 8),      \
        THRESHOLD(n, (m) ^ 40), THRESHOLD(n, (m) ^ 2), THRESHOLD(n, (m) ^ 34), \
        THRESHOLD(n, (m) ^ 10), THRESHOLD(n, (m) ^ 42)
#define ROW(m)                                                                \
    {                                                                         \
        PLACES(1, m), PLACES(2, m), PLACES(3, m), PLACES(4, m), PLACES(5, m), \
            PLACES(6, m), PLACES(7, m)                                        \
    }

/* Of the rows of the matrix: 8 places for 1 bit, 8 for 2, up to 7. */
enum { SIDE = 8 };
static const uint8_t thresholds[SIDE][7 * SIDE] = {
    ROW(0), ROW(48), ROW(12), ROW(60), ROW(3), ROW(51), ROW(15), ROW(63),
};

/* Those of n bits in row y. */
static inline const uint8_t *places_of(uint32_t n, int32_t y)
{
    return &thresholds[y & 7][(n - 1) * SIDE];
}

/* How many of n pixels of one colour are worked out; others are like the one
 * eight before them. */
static inline int32_t first_of(int32_t n)
{
    return n < 2 * SIDE ? n : SIDE;
}

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

/* A channel of n bits, as 8 bits again. */
static PEL_NOINLINE uint32_t dithered_channel(uint32_t c, uint32_t n, int32_t x,
                                              int32_t y)
{
    const uint32_t threshold = places_of(n, y)[x & 7];
    return pel_widen(((c << n) - c + threshold) >> 8, (int)n);
}

static pel_color dithered(const struct pel_format *format, pel_color color,
                          int32_t x, int32_t y)
{
    const uint8_t *const depth = format->dithering->depth;
    const pel_color alpha = color & UINT32_C(0xFF000000);
    if (depth[1] == 0)
        return alpha |
               dithered_channel(pel_gray(color), depth[0], x, y) * 0x010101u;
    return alpha | dithered_channel(pel_red(color), depth[0], x, y) << 16 |
           dithered_channel(pel_green(color), depth[1], x, y) << 8 |
           dithered_channel(pel_blue(color), depth[2], x, y);
}

static PEL_ALWAYS_INLINE void put_pixel(const struct pel_surface *target,
                                        int32_t x, int32_t y, pel_color color)
{
    const pel_color out = dithered(target->format, color, x, y);
    target->format->put(target, x, y, 1, &out);
}

/* A row of pixels of 5-6-5 bits, R 15..11; its places are those of x. */
struct row565 {
    pel_word16 *p, *end;
    const uint8_t *place, *wrap;
};

/* Those formats have loops of their own. */
static inline bool is_565(const struct pel_format *format)
{
    return PEL_KNOW_SIDES && (format->id == PEL_FORMAT_RGB565_LE ||
                              format->id == PEL_FORMAT_RGB565_BE);
}

static struct row565 row565_of(const struct pel_surface *target, int32_t x,
                               int32_t y, int32_t n)
{
    pel_word16 *const p = pel_address16(target, x, y);
    const uint8_t *const places = places_of(5, y);
    return (struct row565){p, p + n, places + (x & 7), places + SIDE};
}

/* Channels times 2^n - 1, red and blue in the halves of a word. */
struct steps565 {
    uint32_t red_blue, green;
};

static PEL_ALWAYS_INLINE struct steps565 steps565_of(uint32_t red_blue,
                                                     uint32_t green)
{
    return (struct steps565){(red_blue << 5) - red_blue, (green << 6) - green};
}

static PEL_ALWAYS_INLINE struct steps565 steps565_of_color(pel_color c)
{
    return steps565_of(c & 0xFF00FFu, c >> 8 & 0xFFu);
}

static PEL_ALWAYS_INLINE void store565(struct row565 *r, struct steps565 s,
                                       bool swapped)
{
    const uint32_t five = r->place[0], six = r->place[SIDE];
    const uint32_t rb = s.red_blue + (five | five << 16), g = s.green + six;
    const uint32_t levels = rb & UINT32_C(0x1F001F00);
    const uint32_t pixel = levels >> 13 | g >> 8 << 5 | levels >> 8;
    *r->p++ = (pel_word16)(swapped ? PEL_BE16(pixel) : PEL_LE16(pixel));
    if (++r->place == r->wrap)
        r->place -= SIDE;
}

static PEL_ALWAYS_INLINE void fill565(const struct pel_surface *target,
                                      const struct pel_spans *spans,
                                      pel_color color, bool swapped)
{
    const struct steps565 steps = steps565_of_color(color);
    const struct pel_span *span = spans->span;
    int32_t y = spans->y;
    for (int32_t i = spans->n; i > 0; i--, span++, y += spans->step) {
        const int32_t n = span->x1 - span->x0, first = first_of(n);
        if (n <= 0)
            continue;
        struct row565 r = row565_of(target, span->x0, y, first);
        while (r.p < r.end)
            store565(&r, steps, swapped);
        if (first < n)
            pel_pattern16(target, span->x0 + first, y, n - first);
    }
}

/* How many colours before the first that is not opaque. */
static PEL_ALWAYS_INLINE int32_t put565(struct row565 r,
                                        const pel_color *colors, bool swapped)
{
    const pel_color *c = colors;
    for (; r.p < r.end && pel_alpha(*c) == 255; c++)
        store565(&r, steps565_of_color(*c), swapped);
    return (int32_t)(c - colors);
}

static PEL_ALWAYS_INLINE void step565(struct row565 r,
                                      const struct pel_planes *planes,
                                      bool swapped)
{
    uint32_t blue = planes->at[0], green = planes->at[1], red = planes->at[2];
    const uint32_t db = planes->dx[0], dg = planes->dx[1], dr = planes->dx[2];
    for (; r.p < r.end; blue += db, green += dg, red += dr)
        store565(&r, steps565_of(red >> 24 << 16 | blue >> 24, green >> 24),
                 swapped);
}

static bool fill_planes(const struct pel_surface *surface, int32_t x, int32_t y,
                        int32_t n, const struct pel_planes *planes)
{
    const struct pel_surface *target = target_of(surface);
    if (!is_565(target->format))
        return false;
    const struct row565 row = row565_of(target, x, y, n);
    if (target->format->id == PEL_FORMAT_RGB565_BE)
        step565(row, planes, true);
    else
        step565(row, planes, false);
    return true;
}

/* The opaque ones that come first. */
static int32_t put_opaque(const struct pel_surface *target, int32_t x,
                          int32_t y, int32_t n, const pel_color *colors)
{
    if (!is_565(target->format))
        return 0;
    const struct row565 row = row565_of(target, x, y, n);
    return target->format->id == PEL_FORMAT_RGB565_BE
               ? put565(row, colors, true)
               : put565(row, colors, false);
}

static void put_colors(const struct pel_surface *surface, int32_t x, int32_t y,
                       int32_t n, const pel_color *colors)
{
    const struct pel_surface *const target = target_of(surface);
    for (const int32_t end = x + n; x < end;) {
        const int32_t done = put_opaque(target, x, y, end - x, colors);
        x += done;
        colors += done;
        if (x < end)
            put_pixel(target, x++, y, *colors++);
    }
}

/* One colour of any alpha. */
static void fill_color(const struct pel_spans *spans, pel_color color)
{
    const struct pel_surface *const target = target_of(spans->surface);
    const struct pel_format *const format = target->format;
    if (is_565(format) && pel_alpha(color) == 255) {
        if (format->id == PEL_FORMAT_RGB565_BE)
            fill565(target, spans, color, true);
        else
            fill565(target, spans, color, false);
        return;
    }
    const struct pel_span *span = spans->span;
    int32_t y = spans->y;
    for (int32_t i = spans->n; i > 0; i--, span++, y += spans->step) {
        int32_t x = span->x0, n = span->x1 - x;
        for (int32_t k = pel_alpha(color) < 255 ? n : first_of(n); k > 0;
             k--, n--)
            put_pixel(target, x++, y, color);
        if (n > 0)
            (format->dithering->pattern ? format->dithering->pattern
                                        : pel_pattern16)(target, x, y, n);
    }
}

static void load_colors(const struct pel_surface *surface, int32_t x, int32_t y,
                        int32_t n, pel_color *colors)
{
    const struct pel_surface *target = target_of(surface);
    target->format->load(target, x, y, n, colors);
}

static uint32_t opaque(uint32_t color)
{
    return color | UINT32_C(0xFF000000);
}

static const struct pel_format proxy_format = {
    255,        32,         4,           opaque, opaque,      fill_color,
    fill_color, put_colors, load_colors, NULL,   fill_planes, target_of,
};

/* A function of its own, to spare the stack of the source. */
static PEL_NOINLINE_32 void set_proxy(struct proxy *proxy, struct pel_spans *to,
                                      const struct pel_spans *spans)
{
    proxy->surface = *spans->surface;
    proxy->surface.format = &proxy_format;
    proxy->target = spans->surface;
    *to = *spans;
    to->surface = &proxy->surface;
}

static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    const struct pel_paint *source = ((const struct pel_dither *)paint)->source;
    PEL_ASSERT(source->fill != fill);
    if (source->fill == fill)
        return;
    struct proxy proxy;
    struct pel_spans all;
    if (spans->surface->format->dithering) {
        set_proxy(&proxy, &all, spans);
        spans = &all;
    }
    source->fill(source, spans);
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
