/* One run of equal 16-bit pixels; as in span32.h. */
#ifndef PEL_FORMAT_SPAN16_H
#define PEL_FORMAT_SPAN16_H

#include "span32.h"

#if PEL_VECTORS

typedef pel_u16x8 pel_value16;

static inline pel_value16 pel_make_value16(uint32_t pixel)
{
    uint16_t v = (uint16_t)pixel;
    return (pel_value16){v, v, v, v, v, v, v, v};
}

/* Fewer than 8 pixels. */
static inline void pel_span16_short(pel_word16 *p, int32_t n, pel_value16 v)
{
    if (n >= 4) {
        memcpy(p, &v, 8);
        memcpy(p + n - 4, &v, 8);
    } else if (n > 0) {
        p[0] = v[0];
        p[n >> 1] = v[0];
        p[n - 1] = v[0];
    }
}

static PEL_ALWAYS_INLINE void pel_span16(pel_word16 *p, int32_t n,
                                         pel_value16 v)
{
    pel_word16 *end = p + n;
    if (n < 8) {
        pel_span16_short(p, n, v);
        return;
    }
    pel_put_u16x8(p, v);
    pel_put_u16x8(end - 8, v);
    if (n <= 16)
        return;
    pel_put_u16x8(p + 8, v);
    pel_put_u16x8(end - 16, v);
    if (n <= 32)
        return;
    p += 16;
    do {
        pel_put_u16x8(p, v);
        pel_put_u16x8(p + 8, v);
        p += 16;
    } while (p < end - 16);
}

#else

typedef uint32_t pel_value16;

static inline pel_value16 pel_make_value16(uint32_t pixel)
{
    return pixel | pixel << 16;
}

static inline void pel_span16(pel_word16 *p, int32_t n, pel_value16 v)
{
    if (n > 0)
        pel_put_halves(p, n, v);
}

#endif
#endif
