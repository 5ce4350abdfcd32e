/* One run of equal 16-bit pixels; as in span32.h. */
#ifndef PEL_FORMAT_SPAN16_H
#define PEL_FORMAT_SPAN16_H

#include "vector.h"
#include "word.h"

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

/* `blocks` >= 1 times eight pixels of v, and where the next ones go. Arm stores
 * four registers with one instruction, which compilers do not find. */
#if defined(__arm__) && defined(__GNUC__)
static inline pel_word32 *pel_put_blocks(pel_word32 *q, int32_t blocks,
                                         uint32_t v)
{
    register uint32_t a __asm__("r3") = v;
    register uint32_t b __asm__("r4") = v;
    register uint32_t c __asm__("r5") = v;
    register uint32_t d __asm__("r6") = v;
    do
        __asm__ volatile("stmia %0!, {%1, %2, %3, %4}"
                         : "+l"(q)
                         : "l"(a), "l"(b), "l"(c), "l"(d)
                         : "memory");
    while (--blocks);
    return q;
}
#else
static inline pel_word32 *pel_put_blocks(pel_word32 *q, int32_t blocks,
                                         uint32_t v)
{
    do {
        q[0] = v;
        q[1] = v;
        q[2] = v;
        q[3] = v;
        q += 4;
    } while (--blocks);
    return q;
}
#endif

/* Pairs of pixels as words, once the address allows it. */
static inline void pel_span16(pel_word16 *p, int32_t n, pel_value16 v)
{
    if (n <= 0)
        return;
    if ((uintptr_t)p & 2) {
        *p++ = (pel_word16)v;
        n--;
    }
    pel_word32 *q = (pel_word32 *)(void *)p;
    if (n >= 8)
        q = pel_put_blocks(q, n >> 3, v);
    /* The rest's bits as signs: a shift and a branch each. */
    const uint32_t rest = (uint32_t)n << 29;
    if ((int32_t)rest < 0) {
        q[0] = v;
        q[1] = v;
        q += 2;
    }
    if ((int32_t)(rest << 1) < 0)
        *q++ = v;
    if (rest << 2)
        *(pel_word16 *)(void *)q = (pel_word16)v;
}

#endif
#endif
