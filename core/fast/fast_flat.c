#include "../format/span16.h"
#include "../format/span32.h"
#include "fast_triangle.h"

#if PEL_FAST_FILLS

static void fill32(const struct pel_surface *s,
                   const struct pel_fast_triangle *t, uint32_t pixel)
{
    const pel_value32 value = pel_make_value32(pixel);
    struct pel_fast_walk w = pel_fast_walk_begin(s, t, 4);
    for (int32_t x, n; pel_fast_walk_next(&w, &x, &n);)
        pel_span32((pel_word32 *)(w.row + 4 * (uintptr_t)x), n, value,
                   PEL_ROWS_AHEAD * w.pitch);
}

static void fill16(const struct pel_surface *s,
                   const struct pel_fast_triangle *t, uint32_t pixel)
{
    const pel_value16 value = pel_make_value16(pixel);
    struct pel_fast_walk w = pel_fast_walk_begin(s, t, 2);
    for (int32_t x, n; pel_fast_walk_next(&w, &x, &n);)
        pel_span16((pel_word16 *)(w.row + 2 * (uintptr_t)x), n, value);
}

/* Formats of one's own fill by themselves. */
bool pel_flat_fast(const struct pel_paint *paint,
                   const struct pel_surface *surface,
                   const struct pel_fast_triangle *triangle)
{
    const struct pel_format *format = surface->format;
    const pel_color color = ((const struct pel_flat *)paint)->color;
    if (pel_alpha(color) < 255 || format->id >= 128)
        return false;
    if (format->bits == 32)
        fill32(surface, triangle, format->pack(color));
    else if (format->bits == 16)
        fill16(surface, triangle, format->pack(color));
    else
        return false;
    return true;
}

#endif
