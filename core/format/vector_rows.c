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

/* Eight colours to pixels; false when one is not opaque. */
static PEL_ALWAYS_INLINE bool put8(pel_word16 *p, const pel_color *colors,
                                   enum order order)
{
    const pel_u32x4 a = pel_get_u32x4(colors), b = pel_get_u32x4(colors + 4);
    pel_u32x4 alpha = a & b;
    pel_u16x8 v = pel_narrow_u16x8(pack4(a, order), pack4(b, order));
    uint64_t half[2];
    memcpy(half, &alpha, 16);
    if ((~(half[0] & half[1]) & UINT64_C(0xFF000000FF000000)) != 0)
        return false;
    if (order == SWAPPED)
        v = v << 8 | v >> 8;
    pel_put_u16x8(p, v);
    return true;
}

static PEL_ALWAYS_INLINE int32_t put_eights(pel_word16 *p, int32_t n,
                                            const pel_color *colors,
                                            enum order order)
{
    int32_t done = 0;
    while (done + 8 <= n && put8(p + done, colors + done, order))
        done += 8;
    return done;
}

int32_t pel_put565_opaque(const struct pel_format *format, pel_word16 *p,
                          int32_t n, const pel_color *colors)
{
    if (format->id == PEL_FORMAT_BGR565_LE)
        return put_eights(p, n, colors, BGR);
    if (format->id == PEL_FORMAT_RGB565_BE)
        return put_eights(p, n, colors, SWAPPED);
    return put_eights(p, n, colors, RGB);
}

#endif
