/* The body of the formats of 5-6-5 bits. */
#ifndef PEL_FORMAT_BODY565_H
#define PEL_FORMAT_BODY565_H

#include "blend565.h"
#include "put565.h"

#define WORD pel_word16
#include "body_word.inc"

static void blend565(const struct pel_spans *spans, pel_color color)
{
#if PEL_VECTORS
    pel_blend565_rows(spans, color);
#else
    blend(spans, color);
#endif
}

static void put565(const struct pel_surface *s, int32_t x, int32_t y, int32_t n,
                   const pel_color *colors)
{
#if PEL_VECTORS
    for (int32_t k; n >= 8; x += k, colors += k, n -= k) {
        k = pel_put565_opaque(s->format, at(s, x, y), n, colors);
        if (k == 0)
            put(s, x, y, k = 8, colors);
    }
#endif
    put(s, x, y, n, colors);
}

#endif
