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

/* Stores the first n < 8 of eight pixels, by stores that may overlap. */
static inline void pel_put_part16(pel_word16 *p, int32_t n, pel_u16x8 v)
{
    uint16_t eight[8];
    pel_put_u16x8(eight, v);
    if (n >= 4) {
        memcpy(p, eight, 8);
        memcpy(p + n - 4, eight + n - 4, 8);
        return;
    }
    pel_word16 elsewhere;
    pel_word16 *q = n > 0 ? p : &elsewhere;
    const int32_t last = n > 0 ? n - 1 : 0, half = (last + 1) >> 1;
    q[0] = eight[0];
    q[half] = eight[half];
    q[last] = eight[last];
}

static PEL_ALWAYS_INLINE void pel_span16(pel_word16 *p, int32_t n,
                                         pel_value16 v)
{
    pel_word16 *const end = p + n - 8;
    if (n < 8) {
        pel_span16_short(p, n, v);
        return;
    }
    pel_put_u16x8(end, v);
    pel_put_u16x8(p, v);
    if (n <= 16)
        return;
    pel_put_u16x8(end - 8, v);
    pel_put_u16x8(p + 8, v);
    for (p += 16; p < end - 8; p += 16) {
        pel_put_u16x8(p, v);
        pel_put_u16x8(p + 8, v);
    }
}

#else

typedef uint32_t pel_value16;

static inline pel_value16 pel_make_value16(uint32_t pixel)
{
    return pixel | pixel << 16;
}

/* n >= 1 pixels: pairs of them as words, once the address allows it. On Arm a
 * left shift puts one bit of a number into the carry and the next one into the
 * sign, so that it decides two branches; compilers do not find that. After the
 * loop `left` is 8 less than the pixels that remain: its low three bits are
 * theirs. Six registers: with a frame pointer Thumb-1 has no seventh. */
#if defined(__arm__) && defined(__GNUC__)
static PEL_HOT void pel_put_pixels16(pel_word16 *p, int32_t n, uint32_t v)
{
    register pel_word16 *q __asm__("r0") = p;
    register int32_t left __asm__("r1") = n;
    register uint32_t a __asm__("r2") = v;
    register uint32_t b __asm__("r3");
    register uint32_t c __asm__("r4");
    register uint32_t d __asm__("r5");
    __asm__ volatile(".syntax unified; lsls %4, %0, #31\n\t"
                     "bcc 1f\n\t"
                     "strh %5, [%0]\n\t"
                     "adds %0, #2\n\t"
                     "subs %1, #1\n"
                     "1:\t"
                     "movs %2, %5\n\t"
                     "subs %1, #8\n\t"
                     "bcc 3f\n\t"
                     "movs %3, %5\n\t"
                     "movs %4, %5\n"
                     "2:\t"
                     "stmia %0!, {%5, %2, %3, %4}\n\t"
                     "subs %1, #8\n\t"
                     "bcs 2b\n"
                     "3:\t"
                     "lsls %4, %1, #30\n\t"
                     "bcc 4f\n\t"
                     "stmia %0!, {%5, %2}\n"
                     "4:\t"
                     "bpl 5f\n\t"
                     "stmia %0!, {%5}\n"
                     "5:\t"
                     "lsls %4, %1, #31\n\t"
                     "bpl 6f\n\t"
                     "strh %5, [%0]\n"
                     "6:"
                     : "+l"(q), "+l"(left), "=l"(b), "=l"(c), "=l"(d)
                     : "l"(a)
                     : "cc", "memory");
}
#else
static inline void pel_put_pixels16(pel_word16 *p, int32_t n, uint32_t v)
{
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

static inline void pel_span16(pel_word16 *p, int32_t n, pel_value16 v)
{
    if (n > 0)
        pel_put_pixels16(p, n, v);
}

#endif
#endif
