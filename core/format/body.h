/* The functions of a format: how colours enter and leave pixels.
 *
 * A body is no header like others: a format includes one after its own pack,
 * unpack and blended (what becomes of a pixel value under a color), which are
 * inlined here, and names its functions in its object. The body of a size of
 * pixels (body8.h to body_bits.h) says where a pixel lies (`at`), where the one
 * on its right does (`next`), and how it is read and written (`get`, `set`). */
#ifndef PEL_FORMAT_BODY_H
#define PEL_FORMAT_BODY_H

#include "word.h"

/* n >= 1 pixels. */
static inline void mix(place p, int32_t n, pel_color color)
{
    const struct pel_premultiplied s = pel_premultiply(color);
    do {
        set(p, blended(get(p), &s));
        p = next(p);
    } while (--n > 0);
}

/* The rule of all formats for one pixel. */
static void over(place p, pel_color color)
{
    const uint32_t alpha = pel_alpha(color);
    if (alpha == 255)
        set(p, pack(color));
    else if (alpha != 0)
        mix(p, 1, color);
}

static inline void blend(const struct pel_spans *spans, pel_color color)
{
    const struct pel_span *span = spans->span;
    int32_t y = spans->y;
    if (pel_alpha(color) == 0)
        return;
    for (int32_t i = spans->n; i > 0; i--, span++, y += spans->step)
        if (span->x0 < span->x1)
            mix(at(spans->surface, span->x0, y), span->x1 - span->x0, color);
}

static void put(const struct pel_surface *s, int32_t x, int32_t y, int32_t n,
                const pel_color *colors)
{
    for (place p = at(s, x, y); n > 0; n--, p = next(p))
        over(p, *colors++);
}

static inline void pattern(const struct pel_surface *s, int32_t x, int32_t y,
                           int32_t n, const uint32_t pixels[8])
{
    for (place p = at(s, x, y); n > 0; n--, p = next(p))
        set(p, pixels[x++ & 7]);
}

static void load(const struct pel_surface *s, int32_t x, int32_t y, int32_t n,
                 pel_color *colors)
{
    for (place p = at(s, x, y); n > 0; n--, p = next(p))
        *colors++ = unpack(get(p));
}

#endif
