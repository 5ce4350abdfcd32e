#include "vector.h"

#if PEL_VECTORS

/* Of the three orders core computes one: red and blue change places in colors
 * for bgr565, bytes in pixels for rgb565_be. */
struct order {
    bool is_bgr, is_swapped;
};

static inline struct order order_of(const struct pel_format *format)
{
    return (struct order){format->id == PEL_FORMAT_BGR565_LE,
                          format->id == PEL_FORMAT_RGB565_BE};
}

static PEL_HOT pel_u32x4 ordered(pel_u32x4 c, struct order o)
{
    if (!o.is_bgr)
        return c;
    return (c & 0xFF00FF00u) | (c >> 16 & 0xFFu) | (c & 0xFFu) << 16;
}

static inline pel_u16x8 swapped(pel_u16x8 v, struct order o)
{
    return o.is_swapped ? (v << 8 | v >> 8) : v;
}

/* Eight colors that are put over pixels: of each channel source * alpha + 128,
 * for pel_divide255_u16x8. */
struct source {
    pel_u16x8 red, green, blue;
    pel_u16x8 rest; /* 255 - alpha */
};

/* The channel at bit `shift` of eight colors. */
static inline pel_u16x8 channel(pel_u32x4 a, pel_u32x4 b, int shift)
{
    return pel_narrow_u16x8(a >> shift & 0xFFu, b >> shift & 0xFFu);
}

static PEL_HOT struct source source_of(pel_u32x4 a, pel_u32x4 b)
{
    const pel_u16x8 alpha = channel(a, b, 24);
    return (struct source){channel(a, b, 16) * alpha + 128,
                           channel(a, b, 8) * alpha + 128,
                           channel(a, b, 0) * alpha + 128, 255 - alpha};
}

/* Channels of 8 bits. */
struct channels {
    pel_u16x8 red, green, blue;
};

static PEL_HOT struct channels channels_of(pel_u16x8 v)
{
    return (struct channels){(v >> 8 & 0xF8) | v >> 13,
                             (v >> 3 & 0xFC) | (v >> 9 & 0x03),
                             (v << 3 & 0xF8) | (v >> 2 & 0x07)};
}

static PEL_HOT pel_u16x8 over8(pel_u16x8 v, const struct source *s,
                               struct order o)
{
    const struct channels c = channels_of(swapped(v, o));
    const pel_u16x8 red = pel_divide255_u16x8(c.red * s->rest + s->red);
    const pel_u16x8 green = pel_divide255_u16x8(c.green * s->rest + s->green);
    const pel_u16x8 blue = pel_divide255_u16x8(c.blue * s->rest + s->blue);
    return swapped((red & 0xF8) << 8 | (green & 0xFC) << 3 | blue >> 3, o);
}

/* Fewer than 4 pixels: the first, the middle and the last one, of which some
 * may be the same. With n <= 0 a variable that nobody reads, as in
 * pel_span32_short. */
static inline void blend_few(pel_word16 *p, int32_t n, const struct source *s,
                             struct order o)
{
    pel_word16 unused = 0;
    pel_word16 *q = n > 0 ? p : &unused;
    const int32_t last = n > 0 ? n - 1 : 0, middle = last >> 1;
    const uint64_t pixels =
        q[0] | (uint64_t)q[middle] << 16 | (uint64_t)q[last] << 32;
    pel_u64x2 v = {pixels, 0};
    v = (pel_u64x2)over8((pel_u16x8)v, s, o);
    q[0] = (pel_word16)v[0];
    q[middle] = (pel_word16)(v[0] >> 16);
    q[last] = (pel_word16)(v[0] >> 32);
}

/* Vectors may overlap: the last one is read before the first store. Of 4 to 7
 * pixels one holds the first and the last four. */
static PEL_ALWAYS_INLINE void blend_span(pel_word16 *p, int32_t n,
                                         const struct source *s, struct order o)
{
    pel_word16 *const end = p + n - 8;
    uint64_t half[2];
    if (n < 4) {
        blend_few(p, n, s, o);
    } else if (n < 8) {
        memcpy(&half[0], p, 8);
        memcpy(&half[1], end + 4, 8);
        pel_put_u16x8(half, over8(pel_get_u16x8(half), s, o));
        memcpy(p, &half[0], 8);
        memcpy(end + 4, &half[1], 8);
    } else {
        const pel_u16x8 tail = over8(pel_get_u16x8(end), s, o);
        for (; p < end; p += 8)
            pel_put_u16x8(p, over8(pel_get_u16x8(p), s, o));
        pel_put_u16x8(end, tail);
    }
}

void pel_blend565(const struct pel_spans *spans, pel_color color)
{
    const struct order o = order_of(spans->surface->format);
    const pel_u32x4 c = ordered((pel_u32x4){0} + color, o);
    const struct source s = source_of(c, c);
    const struct pel_span *span = spans->span;
    const uintptr_t pitch = (uintptr_t)pel_spans_pitch(spans);
    uintptr_t row = pel_column_zero(spans->surface, spans->y, 2);
    for (int32_t n = spans->n; n > 0; n--, span++, row += pitch)
        blend_span((pel_word16 *)(row + 2 * (uintptr_t)span->x0),
                   span->x1 - span->x0, &s, o);
}

/* Red and blue reach their places on both sides of green by one product each,
 * 2^13 and 2^2 times, 5 bits above the pixel's. Shifts take more. */
static inline pel_u32x4 pack4(pel_u32x4 c)
{
    const pel_u32x4 factors = {0x20000004, 0x20000004, 0x20000004, 0x20000004};
    return (pel_dot_s16(c & 0x00F800F8u, factors) | (c & 0xFC00u)) >> 5;
}

static PEL_HOT pel_u16x8 pack8(const pel_color *colors, struct order o)
{
    const pel_u32x4 a = ordered(pel_get_u32x4(colors), o);
    const pel_u32x4 b = ordered(pel_get_u32x4(colors + 4), o);
    return swapped(pel_narrow_u16x8(pack4(a), pack4(b)), o);
}

void pel_pack565(const struct pel_format *format, pel_word16 *p, int32_t n,
                 const pel_color *colors)
{
    const struct order o = order_of(format);
    for (; n >= 8; n -= 8, p += 8, colors += 8)
        pel_put_u16x8(p, pack8(colors, o));
    for (; n > 0; n--)
        *p++ = (pel_word16)format->pack(*colors++);
}

void pel_load565(const struct pel_surface *surface, int32_t x, int32_t y,
                 int32_t n, pel_color *colors)
{
    const struct order o = order_of(surface->format);
    const pel_word16 *p = pel_address16(surface, x, y);
    for (; n >= 8; n -= 8, p += 8, colors += 8) {
        const struct channels c = channels_of(swapped(pel_get_u16x8(p), o));
        const pel_u16x8 low = c.green << 8 | (o.is_bgr ? c.red : c.blue);
        const pel_u16x8 high = (o.is_bgr ? c.blue : c.red) | 0xFF00;
        pel_put_u16x8(colors, pel_zip_low_u16x8(low, high));
        pel_put_u16x8(colors + 4, pel_zip_high_u16x8(low, high));
    }
    for (; n > 0; n--)
        *colors++ = surface->format->unpack(*p++);
}

int32_t pel_put565(const struct pel_format *format, pel_word16 *p, int32_t n,
                   const pel_color *colors)
{
    const struct order o = order_of(format);
    for (int32_t i = n; i >= 8; i -= 8, p += 8, colors += 8) {
        const pel_u32x4 a = ordered(pel_get_u32x4(colors), o);
        const pel_u32x4 b = ordered(pel_get_u32x4(colors + 4), o);
        const enum pel_cover cover = pel_cover_of(a, b);
        if (cover == PEL_OPAQUE) {
            const pel_u16x8 v = pel_narrow_u16x8(pack4(a), pack4(b));
            pel_put_u16x8(p, swapped(v, o));
        } else if (cover == PEL_MIXED) {
            const struct source s = source_of(a, b);
            pel_put_u16x8(p, over8(pel_get_u16x8(p), &s, o));
        }
    }
    return n & ~7;
}

#endif
