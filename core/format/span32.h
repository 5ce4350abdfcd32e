/* One span of equal 32-bit pixels. Vectors may overlap inside the span, so that
 * branches depend on the class of its length alone. */
#ifndef PEL_FORMAT_SPAN32_H
#define PEL_FORMAT_SPAN32_H

#include "vector.h"
#include "word.h"

#if PEL_VECTORS

typedef pel_u32x4 pel_value32;

/* Fewer than 4 pixels. Small shapes have spans of none and of few in no order:
 * writing none somewhere else costs less than a branch guessed wrong. */
static inline void pel_span32_short(pel_word32 *p, int32_t n, uint32_t v)
{
    pel_word32 elsewhere;
    pel_word32 *q = n > 0 ? p : &elsewhere;
    int32_t last = n > 0 ? n - 1 : 0;
    q[0] = v;
    q[last] = v;
    q[(last + 1) >> 1] = v;
}

/* The middle of a span of more than 16 pixels: the caller writes its first and
 * last 8. Two vectors go to `tail`, 16 px before the end; before them two go to
 * p + 8 or, in a span of more than 32 pixels, aligned blocks of four, the first
 * at most 4 px after p. A block begins before `tail`, so it ends inside the
 * span. */
static PEL_ALWAYS_INLINE void pel_span32_long(pel_word32 *p, int32_t n,
                                              pel_value32 v, uintptr_t ahead)
{
    pel_word32 *tail = p + n - 16;
    pel_put_u32x4(tail, v);
    pel_put_u32x4(tail + 4, v);
    if (n <= 32) {
        pel_put_u32x4(p + 8, v);
        pel_put_u32x4(p + 12, v);
        return;
    }
    p = (pel_word32 *)(((uintptr_t)p + 16) & ~(uintptr_t)15);
    do {
        pel_prefetch((uintptr_t)p + ahead);
        pel_put_u32x4(p, v);
        pel_put_u32x4(p + 4, v);
        pel_put_u32x4(p + 8, v);
        pel_put_u32x4(p + 12, v);
        p += 16;
    } while (p < tail);
}

/* `ahead`: bytes to the span of a row below, of which cache lines are asked
 * for: stores retire in order, so each miss would wait for the one before it.
 */
static PEL_ALWAYS_INLINE void pel_span32(pel_word32 *p, int32_t n,
                                         pel_value32 v, uintptr_t ahead)
{
    if (n < 4) {
        pel_span32_short(p, n, v[0]);
        return;
    }
    pel_word32 *end = p + n - 4; /* where the last vector goes */
    pel_put_u32x4(p, v);
    if (n > 8) {
        pel_put_u32x4(p + 4, v);
        if (n > 16)
            pel_span32_long(p, n, v, ahead);
        pel_put_u32x4(end - 4, v);
    }
    pel_put_u32x4(end, v);
}

#else

typedef uint32_t pel_value32;

/* n >= 1 half words of v: its halves are equal, or p is a word's address and n
 * even. On Arm one instruction stores four registers, and one shift tells two
 * bits of a number, as carry and sign: compilers find neither. */
#if defined(__arm__) && defined(__GNUC__)
static PEL_INLINE_FAST void pel_put_halves(pel_word16 *p, int32_t n, uint32_t v)
{
    register uint32_t a __asm__("r2") = v;
    register uint32_t b __asm__("r3");
    register uint32_t c __asm__("r4");
    register uint32_t d __asm__("r5");
    uint32_t left;
    __asm__ volatile(".syntax unified\n\t"
                     "lsls %2, %0, #31\n\t"
                     "bcc 1f\n\t"
                     "strh %6, [%0]\n\t"
                     "adds %0, #2\n\t"
                     "subs %1, #1\n"
                     "1:\t"
                     "movs %3, %6\n\t"
                     "lsrs %2, %1, #3\n\t"
                     "beq 3f\n\t"
                     "movs %4, %6\n\t"
                     "movs %5, %6\n"
                     "2:\t"
                     "stmia %0!, {%6, %3, %4, %5}\n\t"
                     "subs %2, #1\n\t"
                     "bne 2b\n"
                     "3:\t"
                     "lsls %2, %1, #30\n\t"
                     "bcc 4f\n\t"
                     "stmia %0!, {%6, %3}\n"
                     "4:\t"
                     "bpl 5f\n\t"
                     "stmia %0!, {%6}\n"
                     "5:\t"
                     "lsls %1, %1, #31\n\t"
                     "bpl 6f\n\t"
                     "strh %6, [%0]\n"
                     "6:"
                     : "+&l"(p), "+&l"(n), "=&l"(left), "=&l"(b), "=&l"(c),
                       "=&l"(d)
                     : "l"(a)
                     : "cc", "memory");
}
#else
static PEL_INLINE_FAST void pel_put_halves(pel_word16 *p, int32_t n, uint32_t v)
{
    if ((uintptr_t)p & 2) {
        *p++ = (pel_word16)v;
        n--;
    }
    pel_word32 *q = (pel_word32 *)(void *)p;
    for (; n >= 8; n -= 8, q += 4) {
        q[0] = v;
        q[1] = v;
        q[2] = v;
        q[3] = v;
    }
    for (; n >= 2; n -= 2)
        *q++ = v;
    if (n > 0)
        *(pel_word16 *)(void *)q = (pel_word16)v;
}
#endif

static inline void pel_span32(pel_word32 *p, int32_t n, pel_value32 v,
                              uintptr_t ahead)
{
    (void)ahead;
    if (n > 0)
        pel_put_halves((pel_word16 *)(void *)p, 2 * n, v);
}

#endif

static inline pel_value32 pel_make_value32(uint32_t pixel)
{
    return (pel_value32){0} + pixel;
}

#endif
