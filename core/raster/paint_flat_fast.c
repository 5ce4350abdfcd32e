#include "fast_triangle.h"

#if PEL_FAST_64BIT

#include "../format/span16.h"
#include "../format/span32.h"

static void fill32(const struct pel_surface *s,
                   const struct pel_fast_triangle *t, uint32_t pixel)
{
    const pel_value32 value = pel_make_value32(pixel);
    const uintptr_t pitch = (uintptr_t)(ptrdiff_t)s->stride;
    struct pel_slope a = t->whole, b = t->upper;
    uintptr_t line = pel_column_zero(s, t->y0, 4);
    for (int32_t y = t->y0, n; y < t->y2; y++, line += pitch) {
        if (y == t->y1)
            b = t->lower;
        int32_t x = pel_fast_next(&a, &b, &n);
        pel_span32((pel_word32 *)(line + 4 * (uintptr_t)x), n, value);
    }
}

static void fill16(const struct pel_surface *s,
                   const struct pel_fast_triangle *t, uint32_t pixel)
{
    const pel_value16 value = pel_make_value16(pixel);
    const uintptr_t pitch = (uintptr_t)(ptrdiff_t)s->stride;
    struct pel_slope a = t->whole, b = t->upper;
    uintptr_t line = pel_column_zero(s, t->y0, 2);
    for (int32_t y = t->y0, n; y < t->y2; y++, line += pitch) {
        if (y == t->y1)
            b = t->lower;
        int32_t x = pel_fast_next(&a, &b, &n);
        pel_span16((pel_word16 *)(line + 2 * (uintptr_t)x), n, value);
    }
}

bool pel_flat_fast(const struct pel_paint *paint,
                   const struct pel_surface *surface,
                   const struct pel_fast_triangle *triangle)
{
    const struct pel_format *format = surface->format;
    pel_color color = ((const struct pel_flat *)paint)->color;
    if (pel_alpha(color) != 255)
        return false;
    if (format->word == 4)
        fill32(surface, triangle, format->pack(color));
    else if (format->word == 2)
        fill16(surface, triangle, format->pack(color));
    else
        return false;
    return true;
}

#endif
