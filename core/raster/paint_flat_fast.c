#include "fast_triangle.h"

#if PEL_FAST_64BIT

#include "../format/blend32.h"
#include "../format/blend565.h"
#include "../format/span16.h"
#include "../format/span32.h"

/* Small triangles find their few rows in the cache, or do not wait long. */
enum { ROWS_WORTH_PREFETCHING = 16, ROWS_AHEAD = 4 };

static void fill32(const struct pel_surface *s,
                   const struct pel_fast_triangle *t, pel_color color)
{
    const pel_value32 value = pel_make_value32(s->format->pack(color));
    struct pel_fast_walk w = pel_fast_walk_begin(s, t, 4);
    if (t->y2 - t->y0 < ROWS_WORTH_PREFETCHING) {
        for (int32_t x, n; pel_fast_walk_next(&w, &x, &n);)
            pel_span32((pel_word32 *)(w.line + 4 * (uintptr_t)x), n, value);
        return;
    }
    const uintptr_t ahead = pel_fast_walk_ahead(&w, ROWS_AHEAD, 4);
    for (int32_t x, n; pel_fast_walk_next(&w, &x, &n);) {
        uintptr_t p = w.line + 4 * (uintptr_t)x;
        pel_prefetch_run(p + ahead, 4 * n);
        pel_span32((pel_word32 *)p, n, value);
    }
}

static void fill16(const struct pel_surface *s,
                   const struct pel_fast_triangle *t, pel_color color)
{
    const pel_value16 value = pel_make_value16(s->format->pack(color));
    struct pel_fast_walk w = pel_fast_walk_begin(s, t, 2);
    for (int32_t x, n; pel_fast_walk_next(&w, &x, &n);)
        pel_span16((pel_word16 *)(w.line + 2 * (uintptr_t)x), n, value);
}

static void blend32(const struct pel_surface *s,
                    const struct pel_fast_triangle *t, pel_color color)
{
    const struct pel_blend32 b = pel_blend32_make(s->format, color);
    struct pel_fast_walk w = pel_fast_walk_begin(s, t, 4);
    const uintptr_t ahead = pel_fast_walk_ahead(&w, ROWS_AHEAD, 4);
    for (int32_t x, n; pel_fast_walk_next(&w, &x, &n);) {
        uintptr_t p = w.line + 4 * (uintptr_t)x;
        pel_prefetch_run(p + ahead, 4 * n);
        pel_blend32_run((pel_word32 *)p, n, &b);
    }
}

static void blend565(const struct pel_surface *s,
                     const struct pel_fast_triangle *t, pel_color color)
{
    const struct pel_blend565 b = pel_blend565_make(s->format, color);
    struct pel_fast_walk w = pel_fast_walk_begin(s, t, 2);
    for (int32_t x, n; pel_fast_walk_next(&w, &x, &n);)
        pel_blend565_run((pel_word16 *)(w.line + 2 * (uintptr_t)x), n, &b);
}

typedef void writer(const struct pel_surface *s,
                    const struct pel_fast_triangle *t, pel_color color);

static writer *opaque_writer(const struct pel_format *format)
{
    if (format->bits == 32)
        return fill32;
    return format->bits == 16 ? fill16 : NULL;
}

/* By layout, which only the ids of core's own formats tell. */
static writer *blend_writer(const struct pel_format *format)
{
    switch (format->blend ? format->id : 0) {
    case PEL_FORMAT_XRGB8888:
    case PEL_FORMAT_XBGR8888:
    case PEL_FORMAT_RGBX8888:
    case PEL_FORMAT_BGRX8888:
        return blend32;
    case PEL_FORMAT_RGB565_LE:
    case PEL_FORMAT_RGB565_BE:
    case PEL_FORMAT_BGR565_LE:
        return blend565;
    default:
        return NULL;
    }
}

bool pel_flat_fast(const struct pel_paint *paint,
                   const struct pel_surface *surface,
                   const struct pel_fast_triangle *triangle)
{
    const pel_color color = ((const struct pel_flat *)paint)->color;
    if (pel_alpha(color) == 0)
        return true;
    writer *write = pel_alpha(color) == 255 ? opaque_writer(surface->format)
                                            : blend_writer(surface->format);
    if (write)
        write(surface, triangle, color);
    return write != NULL;
}

#endif
