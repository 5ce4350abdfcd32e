#include "vector.h"

#if PEL_VECTORS

/* Colors as the bytes of two pixels, 16 bits each, that are put over others of
 * any order of channels. */
struct source {
    pel_u16x8 sources; /* byte of the color * alpha + 128 */
    pel_u16x8 rests;   /* 255 - alpha */
};

static inline pel_u16x8 low_bytes(pel_u32x4 v)
{
    return (pel_u16x8)pel_zip_low_u8x16((pel_u8x16)v, (pel_u8x16){0});
}

static inline pel_u16x8 high_bytes(pel_u32x4 v)
{
    return (pel_u16x8)pel_zip_high_u8x16((pel_u8x16)v, (pel_u8x16){0});
}

/* Four pixels; sources of the first two and of the others. */
static PEL_HOT pel_u32x4 over4(pel_u32x4 below, const struct source *a,
                               const struct source *b)
{
    return (pel_u32x4)pel_join_u8x16(
        pel_divide255_u16x8(low_bytes(below) * a->rests + a->sources),
        pel_divide255_u16x8(high_bytes(below) * b->rests + b->sources));
}

static inline struct source source_of(const struct pel_format *format,
                                      pel_color color)
{
    const uint16_t alpha = (uint16_t)pel_alpha(color);
    const uint16_t rest = (uint16_t)(255 - alpha);
    const pel_u32x4 zero = {0};
    /* The X byte becomes 255 whatever is in memory: (0 d + 255 255) / 255. */
    const pel_u16x8 x = low_bytes(zero + format->pack(0));
    const pel_u16x8 source = low_bytes(zero + format->pack(color));
    return (struct source){source * alpha + x * rest + 128, ~x & rest};
}

/* Fewer than 4 pixels: the first, the middle and the last one, of which some
 * may be the same. With n <= 0 a variable that nobody reads, as in
 * pel_span32_short. */
static inline void blend_few(pel_word32 *p, int32_t n, const struct source *s)
{
    pel_word32 unused = 0;
    pel_word32 *q = n > 0 ? p : &unused;
    const int32_t last = n > 0 ? n - 1 : 0, middle = last >> 1;
    pel_u32x4 v = {q[0], q[middle], q[last], 0};
    v = over4(v, s, s);
    q[0] = v[0];
    q[middle] = v[1];
    q[last] = v[2];
}

/* The last four may overlap those before them: they are read before the first
 * store, and stored last. `ahead`: bytes to the span a few rows below, which is
 * prefetched. */
static PEL_ALWAYS_INLINE void blend_span(pel_word32 *p, int32_t n,
                                         const struct source *s,
                                         uintptr_t ahead)
{
    if (n < 4) {
        blend_few(p, n, s);
        return;
    }
    pel_word32 *const end = p + n - 4;
    const pel_u32x4 tail = over4(pel_get_u32x4(end), s, s);
    pel_put_u32x4(p, over4(pel_get_u32x4(p), s, s));
    for (p += 4; p < end; p += 4) {
        pel_prefetch((uintptr_t)p + ahead);
        pel_put_u32x4(p, over4(pel_get_u32x4(p), s, s));
    }
    pel_put_u32x4(end, tail);
}

void pel_blend32(const struct pel_spans *spans, pel_color color)
{
    if (pel_alpha(color) == 0)
        return; /* the X byte stays as it is, too */
    const struct source s = source_of(spans->surface->format, color);
    const struct pel_span *span = spans->span;
    const uintptr_t pitch = (uintptr_t)pel_spans_pitch(spans);
    const uintptr_t ahead = PEL_ROWS_AHEAD * pitch;
    uintptr_t row = pel_column_zero(spans->surface, spans->y, 4);
    for (int32_t n = spans->n; n > 0; n--, span++, row += pitch)
        blend_span((pel_word32 *)(row + 4 * (uintptr_t)span->x0),
                   span->x1 - span->x0, &s, ahead);
}

/* Four colors over pixels of xrgb8888, whose X is set but where alpha is 0. */
static PEL_HOT pel_u32x4 colors_over4(pel_u32x4 below, pel_u32x4 colors)
{
    const pel_u32x4 alpha = colors >> 24, a = alpha | alpha << 16;
    const pel_u16x8 low = (pel_u16x8)PEL_LANES(a, a, 0, 0, 1, 1);
    const pel_u16x8 high = (pel_u16x8)PEL_LANES(a, a, 2, 2, 3, 3);
    const struct source first = {low_bytes(colors) * low + 128, 255 - low};
    const struct source other = {high_bytes(colors) * high + 128, 255 - high};
    return over4(below, &first, &other) | ((0 - alpha) & 0xFF000000u);
}

void pel_put32(const struct pel_surface *surface, int32_t x, int32_t y,
               int32_t n, const pel_color *colors)
{
    pel_word32 *p = pel_address32(surface, x, y);
    for (; n >= 8; n -= 8, p += 8, colors += 8) {
        const pel_u32x4 a = pel_get_u32x4(colors);
        const pel_u32x4 b = pel_get_u32x4(colors + 4);
        const enum pel_cover cover = pel_cover_of(a, b);
        if (cover == PEL_CLEAR)
            continue;
        const bool mixed = cover == PEL_MIXED;
        pel_put_u32x4(p, mixed ? colors_over4(pel_get_u32x4(p), a) : a);
        pel_put_u32x4(p + 4, mixed ? colors_over4(pel_get_u32x4(p + 4), b) : b);
    }
    for (; n > 0; n--, p++, colors++)
        if (pel_alpha(*colors) > 0)
            *p = pel_mix(*p, *colors, pel_alpha(*colors));
}

void pel_copy32(pel_word32 *to, const pel_word32 *from, int32_t n, uint32_t set)
{
    for (; n >= 16; n -= 16, from += 16, to += 16) {
        const pel_u32x4 a = pel_get_u32x4(from), b = pel_get_u32x4(from + 4);
        const pel_u32x4 c = pel_get_u32x4(from + 8);
        const pel_u32x4 d = pel_get_u32x4(from + 12);
        pel_put_u32x4(to, a | set);
        pel_put_u32x4(to + 4, b | set);
        pel_put_u32x4(to + 8, c | set);
        pel_put_u32x4(to + 12, d | set);
    }
    for (; n > 0; n--)
        *to++ = *from++ | set;
}

#endif
