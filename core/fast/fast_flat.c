#include "../format/blend32.h"
#include "../format/blend565.h"
#include "../format/span16.h"
#include "../format/span32.h"
#include "fast_triangle.h"

#if PEL_FAST_FILLS

enum { ROWS_AHEAD = 4 };

static void fill32(const struct pel_surface *s,
                   const struct pel_fast_triangle *t, pel_color color)
{
    const pel_value32 value = pel_make_value32(s->format->pack(color));
    struct pel_fast_walk w = pel_fast_walk_begin(s, t, 4);
    const uintptr_t ahead = pel_fast_walk_ahead(&w, ROWS_AHEAD, 4);
    for (int32_t x, n; pel_fast_walk_next(&w, &x, &n);)
        pel_span32((pel_word32 *)(w.row + 4 * (uintptr_t)x), n, value, ahead);
}

static void fill16(const struct pel_surface *s,
                   const struct pel_fast_triangle *t, pel_color color)
{
    const pel_value16 value = pel_make_value16(s->format->pack(color));
    struct pel_fast_walk w = pel_fast_walk_begin(s, t, 2);
    for (int32_t x, n; pel_fast_walk_next(&w, &x, &n);)
        pel_span16((pel_word16 *)(w.row + 2 * (uintptr_t)x), n, value);
}

/* Formats of one's own fill by themselves. */
static bool fill(const struct pel_surface *s, const struct pel_fast_triangle *t,
                 pel_color color)
{
    if (s->format->id >= 128)
        return false;
    if (s->format->bits == 32)
        fill32(s, t, color);
    else if (s->format->bits == 16)
        fill16(s, t, color);
    else
        return false;
    return true;
}

#if PEL_VECTORS

/* Not inlined: beside the others it takes registers from fill16 (clang). */
static PEL_NOINLINE void blend32(const struct pel_surface *s,
                                 const struct pel_fast_triangle *t,
                                 pel_color color)
{
    const struct pel_blend32 b = pel_blend32_make(s->format, color);
    struct pel_fast_walk w = pel_fast_walk_begin(s, t, 4);
    const uintptr_t ahead = pel_fast_walk_ahead(&w, ROWS_AHEAD, 4);
    for (int32_t x, n; pel_fast_walk_next(&w, &x, &n);) {
        uintptr_t p = w.row + 4 * (uintptr_t)x;
        pel_blend32_span((pel_word32 *)p, n, &b, ahead);
    }
}

static void blend565(const struct pel_surface *s,
                     const struct pel_fast_triangle *t, pel_color color)
{
    const struct pel_blend565 b = pel_blend565_make(s->format, color);
    struct pel_fast_walk w = pel_fast_walk_begin(s, t, 2);
    for (int32_t x, n; pel_fast_walk_next(&w, &x, &n);)
        pel_blend565_span((pel_word16 *)(w.row + 2 * (uintptr_t)x), n, &b);
}

/* Chosen by id, which tells the layout of core's own formats. */
static bool blend(const struct pel_surface *s,
                  const struct pel_fast_triangle *t, pel_color color)
{
    switch (s->format->blend ? s->format->id : 0) {
    case PEL_FORMAT_XRGB8888:
    case PEL_FORMAT_XBGR8888:
    case PEL_FORMAT_RGBX8888:
    case PEL_FORMAT_BGRX8888:
        blend32(s, t, color);
        return true;
    case PEL_FORMAT_RGB565_LE:
    case PEL_FORMAT_RGB565_BE:
    case PEL_FORMAT_BGR565_LE:
        blend565(s, t, color);
        return true;
    default:
        return false;
    }
}

#else

/* The format's own loop does as well. */
static bool blend(const struct pel_surface *s,
                  const struct pel_fast_triangle *t, pel_color color)
{
    (void)s;
    (void)t;
    (void)color;
    return false;
}

#endif

bool pel_flat_fast(const struct pel_paint *paint,
                   const struct pel_surface *surface,
                   const struct pel_fast_triangle *triangle)
{
    const pel_color color = ((const struct pel_flat *)paint)->color;
    if (pel_alpha(color) == 255)
        return fill(surface, triangle, color);
    return pel_alpha(color) == 0 || blend(surface, triangle, color);
}

#endif
