/* One run of equal 32-bit pixels. The vector form stores whole vectors that may
 * overlap inside the run, in classes of length, so that the branches depend on
 * the class alone; it never stores outside [p, p + n). */
#ifndef PEL_FORMAT_SPAN32_H
#define PEL_FORMAT_SPAN32_H

#include "vector.h"
#include "word32.h"

#if PEL_VECTORS

typedef pel_u32x4 pel_value32;

static inline pel_value32 pel_make_value32(uint32_t pixel)
{
    return (pel_value32){pixel, pixel, pixel, pixel};
}

/* More than 32 pixels: the first and last 16 are stored already. */
static inline void pel_span32_middle(pel_word32 *p, const pel_word32 *end,
                                     pel_value32 v)
{
    do {
        pel_put_u32x4(p, v);
        pel_put_u32x4(p + 4, v);
        pel_put_u32x4(p + 8, v);
        pel_put_u32x4(p + 12, v);
        p += 16;
    } while (p < end);
}

static PEL_ALWAYS_INLINE void pel_span32(pel_word32 *p, int32_t n,
                                         pel_value32 v)
{
    pel_word32 *end = p + n;
    if (n < 4) {
        if (n <= 0)
            return;
        p[0] = v[0];
        p[n >> 1] = v[0];
        p[n - 1] = v[0];
        return;
    }
    pel_put_u32x4(p, v);
    pel_put_u32x4(end - 4, v);
    if (n <= 8)
        return;
    pel_put_u32x4(p + 4, v);
    pel_put_u32x4(end - 8, v);
    if (n <= 16)
        return;
    pel_put_u32x4(p + 8, v);
    pel_put_u32x4(p + 12, v);
    pel_put_u32x4(end - 16, v);
    pel_put_u32x4(end - 12, v);
    if (n > 32)
        pel_span32_middle(p + 16, end - 16, v);
}

#else

typedef uint32_t pel_value32;

static inline pel_value32 pel_make_value32(uint32_t pixel)
{
    return pixel;
}

static inline void pel_span32(pel_word32 *p, int32_t n, pel_value32 v)
{
    for (; n >= 4; n -= 4, p += 4) {
        p[0] = v;
        p[1] = v;
        p[2] = v;
        p[3] = v;
    }
    for (; n > 0; n--)
        *p++ = v;
}

#endif
#endif
