#include "blend32.h"
#include "blend565.h"

#if PEL_VECTORS

enum { ROWS_AHEAD = 4 };

void pel_blend32_rows(const struct pel_spans *spans, pel_color color)
{
    if (pel_alpha(color) == 0)
        return; /* the X byte stays as it is, too */
    const struct pel_blend32 b =
        pel_blend32_make(spans->surface->format, color);
    const struct pel_span *span = spans->span;
    const uintptr_t ahead = ROWS_AHEAD * (uintptr_t)pel_spans_pitch(spans);
    int32_t y = spans->y;
    for (int32_t i = 0; i < spans->n; i++, span++, y += spans->step)
        pel_blend32_span(pel_address32(spans->surface, span->x0, y),
                         span->x1 - span->x0, &b, ahead);
}

void pel_blend565_rows(const struct pel_spans *spans, pel_color color)
{
    const struct pel_blend565 b =
        pel_blend565_make(spans->surface->format, color);
    const struct pel_span *span = spans->span;
    int32_t y = spans->y;
    for (int32_t i = 0; i < spans->n; i++, span++, y += spans->step)
        pel_blend565_span(pel_address16(spans->surface, span->x0, y),
                          span->x1 - span->x0, &b);
}

enum order { RGB, BGR, SWAPPED };

static PEL_ALWAYS_INLINE pel_u32x4 pack4(pel_u32x4 c, enum order order)
{
    if (order == BGR)
        return (c << 8 & 0xF800u) | (c >> 5 & 0x07E0u) | (c >> 19 & 0x001Fu);
    return (c >> 8 & 0xF800u) | (c >> 5 & 0x07E0u) | (c >> 3 & 0x001Fu);
}

/* Of eight colors. */
enum cover { CLEAR, MIXED, OPAQUE };

static PEL_ALWAYS_INLINE enum cover cover_of(pel_u32x4 a, pel_u32x4 b)
{
    const uint64_t alphas = UINT64_C(0xFF000000FF000000);
    const pel_u32x4 all[2] = {a & b, a | b};
    uint64_t half[4];
    memcpy(half, all, 32);
    if ((~(half[0] & half[1]) & alphas) == 0)
        return OPAQUE;
    return ((half[2] | half[3]) & alphas) == 0 ? CLEAR : MIXED;
}

/* Eight colors over pixels. */
static PEL_ALWAYS_INLINE pel_u16x8 over8(pel_u16x8 below, pel_u32x4 a,
                                         pel_u32x4 b, enum order order)
{
    const pel_u16x8 alpha = pel_narrow_u16x8(a >> 24, b >> 24);
    const pel_u16x8 red =
        pel_narrow_u16x8(a >> 16 & 0xFFu, b >> 16 & 0xFFu) * alpha + 128;
    const pel_u16x8 green =
        pel_narrow_u16x8(a >> 8 & 0xFFu, b >> 8 & 0xFFu) * alpha + 128;
    const pel_u16x8 blue = pel_narrow_u16x8(a & 0xFFu, b & 0xFFu) * alpha + 128;
    const struct pel_blend565 m = {order == BGR ? blue : red, green,
                                   order == BGR ? red : blue, 255 - alpha,
                                   order == SWAPPED};
    return pel_blend565_vector(below, &m);
}

static PEL_ALWAYS_INLINE void put8(pel_word16 *p, const pel_color *colors,
                                   enum order order)
{
    const pel_u32x4 a = pel_get_u32x4(colors), b = pel_get_u32x4(colors + 4);
    const enum cover cover = cover_of(a, b);
    if (cover == MIXED) {
        pel_put_u16x8(p, over8(pel_get_u16x8(p), a, b, order));
    } else if (cover == OPAQUE) {
        pel_u16x8 v = pel_narrow_u16x8(pack4(a, order), pack4(b, order));
        if (order == SWAPPED)
            v = v << 8 | v >> 8;
        pel_put_u16x8(p, v);
    }
}

static PEL_ALWAYS_INLINE void put_eights(pel_word16 *p, int32_t n,
                                         const pel_color *colors,
                                         enum order order)
{
    for (; n >= 8; n -= 8, p += 8, colors += 8)
        put8(p, colors, order);
}

int32_t pel_put565(const struct pel_format *format, pel_word16 *p, int32_t n,
                   const pel_color *colors)
{
    if (format->id == PEL_FORMAT_BGR565_LE)
        put_eights(p, n, colors, BGR);
    else if (format->id == PEL_FORMAT_RGB565_BE)
        put_eights(p, n, colors, SWAPPED);
    else
        put_eights(p, n, colors, RGB);
    return n & ~7;
}

/* Channels c over d, by the weight a, 0..255. */
static PEL_ALWAYS_INLINE pel_u16x8 over(pel_u8x16 d, pel_u8x16 c, pel_u32x4 a)
{
    const pel_u16x8 weight = (pel_u16x8)a;
    return pel_divide255_u16x8((pel_u16x8)d * (255 - weight) +
                               (pel_u16x8)c * weight + 128);
}

/* Four colors over pixels of xrgb8888, whose X is set but where alpha is 0. */
static PEL_ALWAYS_INLINE pel_u32x4 over4(pel_u32x4 below, pel_u32x4 colors)
{
    const pel_u32x4 alpha = colors >> 24, a = alpha | alpha << 16;
    const pel_u8x16 d = (pel_u8x16)below, c = (pel_u8x16)colors, zero = {0};
    const pel_u16x8 low =
        over(pel_zip_low_u8x16(d, zero), pel_zip_low_u8x16(c, zero),
             PEL_LANES(a, a, 0, 0, 1, 1));
    const pel_u16x8 high =
        over(pel_zip_high_u8x16(d, zero), pel_zip_high_u8x16(c, zero),
             PEL_LANES(a, a, 2, 2, 3, 3));
    return (pel_u32x4)pel_join_u8x16(low, high) |
           ((pel_u32x4)(alpha != 0) & 0xFF000000u);
}

int32_t pel_put32(const struct pel_format *format, pel_word32 *p, int32_t n,
                  const pel_color *colors)
{
    if (format->id != PEL_FORMAT_XRGB8888 && format->id != PEL_FORMAT_ARGB8888)
        return 0;
    for (int32_t i = n; i >= 8; i -= 8, p += 8, colors += 8) {
        const pel_u32x4 a = pel_get_u32x4(colors);
        const pel_u32x4 b = pel_get_u32x4(colors + 4);
        const enum cover cover = cover_of(a, b);
        if (cover == CLEAR)
            continue;
        const bool mixed = cover == MIXED;
        pel_put_u32x4(p, mixed ? over4(pel_get_u32x4(p), a) : a);
        pel_put_u32x4(p + 4, mixed ? over4(pel_get_u32x4(p + 4), b) : b);
    }
    return n & ~7;
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
