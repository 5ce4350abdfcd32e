#include "smooth_dither.h"

#include "../format/word.h"

#define OPAQUE UINT32_C(0xFF000000)

/* The thresholds of a row, and the depths that are shown. */
struct row {
    const uint8_t *thresholds, *depth;
    bool is_565;
};

/* The level of a channel of n bits, widened. */
static inline uint32_t level(const struct row *r, uint32_t c, uint32_t n,
                             int32_t x)
{
    const uint32_t t = r->thresholds[(n - 1) * 8 + ((uint32_t)x & 7)];
    return pel_widen(((c << n) - c + t) >> 8, (int)n);
}

static inline pel_color dithered_any(const struct row *r, pel_color c,
                                     int32_t x)
{
    const uint8_t *const n = r->depth;
    if (n[1] == 0)
        return OPAQUE | level(r, pel_gray(c), n[0], x) * 0x010101u;
    return OPAQUE | level(r, pel_red(c), n[0], x) << 16 |
           level(r, pel_green(c), n[1], x) << 8 |
           level(r, pel_blue(c), n[2], x);
}

/* Red and blue at once. */
static inline pel_color dithered_565(const struct row *r, pel_color c,
                                     int32_t x)
{
    const uint8_t *const t = r->thresholds + ((uint32_t)x & 7);
    uint32_t rb = c & UINT32_C(0xFF00FF), g = pel_green(c);
    rb = ((rb << 5) - rb + t[4 * 8] * 0x10001u) >> 8 & UINT32_C(0x1F001F);
    g = ((g << 6) - g + t[5 * 8]) >> 8;
    return OPAQUE | rb << 3 | (rb >> 2 & 0x70007) | (g << 2 | g >> 4) << 8;
}

static inline pel_color dithered(const struct row *r, pel_color c, int32_t x)
{
    return r->is_565 ? dithered_565(r, c, x) : dithered_any(r, c, x);
}

static struct row row_of(const struct pel_surface *s,
                         const pel_thresholds *rows, int32_t y)
{
    const uint8_t *const n = pel_smooth_depth(s);
    return (struct row){rows[y & 7], n, n[0] == 5 && n[1] == 6 && n[2] == 5};
}

void pel_smooth_dither_fill(const struct pel_surface *s,
                            const struct pel_spans *spans, pel_color color,
                            const pel_thresholds *rows)
{
    const struct pel_span *span = spans->span;
    int32_t y = spans->y;
    for (int32_t i = spans->n; i > 0; i--, span++, y += spans->step) {
        int32_t x = span->x0;
        if (x >= span->x1)
            continue;
        const struct row row = row_of(s, rows, y);
        pel_color *at = (void *)pel_address(s, x, y, 4);
        for (; x < span->x1; x++)
            *at++ = dithered(&row, color, x);
    }
}

int32_t pel_smooth_dither_put(const struct pel_surface *s,
                              const struct pel_spans *spans,
                              const pel_color *colors,
                              const pel_thresholds *rows)
{
    const struct pel_span *const span = spans->span;
    const struct row row = row_of(s, rows, spans->y);
    pel_color *at = (void *)pel_address(s, span->x0, spans->y, 4);
    int32_t x = span->x0;
    for (; x < span->x1 && *colors >= OPAQUE; x++)
        *at++ = dithered(&row, *colors++, x);
    return x - span->x0;
}
