/* The body of formats whose pixel is a word of 32 bits. */
#ifndef PEL_FORMAT_BODY32_H
#define PEL_FORMAT_BODY32_H

#include "blend32.h"

#define WORD pel_word32
#include "body_word.inc"

static void blend32(const struct pel_spans *spans, pel_color color)
{
#if PEL_VECTORS
    pel_blend32_rows(spans, color);
#else
    blend(spans, color);
#endif
}

#if PEL_VECTORS
/* Are colours pixels but for their alpha? Known at compile time. */
static inline pel_u32x4 pack4(const pel_color *c)
{
    if (pack(0x010203) == (pack(0) | 0x010203))
        return pel_get_u32x4(c) | pack(0);
    return (pel_u32x4){pack(c[0]), pack(c[1]), pack(c[2]), pack(c[3])};
}
#endif

static void put32(const struct pel_surface *s, int32_t x, int32_t y, int32_t n,
                  const pel_color *colors)
{
#if PEL_VECTORS
    for (place p = at(s, x, y); n >= 4; p += 4, x += 4, colors += 4, n -= 4) {
        uint64_t c[2];
        memcpy(c, colors, 16);
        const uint64_t alpha = UINT64_C(0xFF000000FF000000);
        if ((c[0] & c[1] & alpha) == alpha)
            pel_put_u32x4(p, pack4(colors));
        else if ((c[0] | c[1]) & alpha)
            pel_put32_four(p, colors, pack4(colors), pack(0));
    }
#endif
    put(s, x, y, n, colors);
}

#endif
