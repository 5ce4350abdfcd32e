/* Edges in 16.16: the slope is rounded once, and its error grows from row to
 * row. */
#include "scanline.h"

/* floor(n / d), d > 0. */
static int64_t floor_64(int64_t n, int64_t d)
{
    return n / d - (n % d < 0);
}

/* dx / dy in 16.16. Products of short edges fit 32 bits, where small CPUs
 * divide faster. */
static PEL_ALWAYS_INLINE int64_t slope(int32_t dx, int32_t dy, bool rounded)
{
    if (!rounded)
        return dx == (int16_t)dx ? dx * 65536 / dy : (int64_t)dx * 65536 / dy;
    if (dx > -8192 && dx < 8192 && dy < 8192) {
        const int32_t n = 2 * 65536 * dx + dy;
        return n / (2 * dy) - (n % (2 * dy) < 0);
    }
    return floor_64((int64_t)dx * 131072 + dy, 2 * (int64_t)dy);
}

static PEL_ALWAYS_INLINE void start(struct walk *w, const struct pel_point *a,
                                    const struct pel_point *b, bool rounded)
{
    const int32_t t = pel_pixel_center(pel_first_pixel(a->y)) - a->y;
    w->fixed_step = slope(b->x - a->x, b->y - a->y, rounded);
    w->fixed = (int64_t)a->x * 256 + ((w->fixed_step * t) >> 8);
}

static void start_rounded(struct walk *w, const struct pel_point *a,
                          const struct pel_point *b)
{
    start(w, a, b, true);
}

static void start_truncated(struct walk *w, const struct pel_point *a,
                            const struct pel_point *b)
{
    start(w, a, b, false);
}

static void next(struct walk *w)
{
    w->fixed += w->fixed_step;
}

static int32_t pixel_of(const struct walk *w)
{
    return (int32_t)((w->fixed + 0x7FFF) >> 16);
}

static void draw_rounded(const struct pel_surface *s,
                         const struct pel_point v[3], uint32_t pixel)
{
    static const struct scanline kind = {start_rounded, next, pixel_of};
    scanline_draw(s, &kind, v, pixel);
}

static void draw_truncated(const struct pel_surface *s,
                           const struct pel_point v[3], uint32_t pixel)
{
    static const struct scanline kind = {start_truncated, next, pixel_of};
    scanline_draw(s, &kind, v, pixel);
}

const struct fill_method fill_fixed_rounded = {"16.16 rounded", 8,
                                               draw_rounded};
const struct fill_method fill_fixed_truncated = {"16.16 truncated", 8,
                                                 draw_truncated};
