/* One span of equal 32-bit pixels. Vectors may overlap inside the span. */
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

/* Stores the first n < 4 of four pixels, as pel_span32_short. */
static inline void pel_put_part32(pel_word32 *p, int32_t n, pel_u32x4 v)
{
    pel_word32 elsewhere;
    pel_word32 *q = n > 0 ? p : &elsewhere;
    const int32_t last = n > 0 ? n - 1 : 0, half = (last + 1) >> 1;
    q[0] = v[0];
    q[half] = v[half];
    q[last] = v[last];
}

/* Stores retire in order, so each that misses the cache waits for the one
 * before it. So the cache lines `ahead` bytes on, those of a row below, are
 * asked for meanwhile. */
static PEL_ALWAYS_INLINE void pel_span32(pel_word32 *p, int32_t n,
                                         pel_value32 v, uintptr_t ahead)
{
    if (n < 4) {
        pel_span32_short(p, n, v[0]);
        return;
    }
    pel_word32 *const end = p + n - 4;
    pel_put_u32x4(end, v);
    pel_put_u32x4(p, v);
    if (n <= 8)
        return;
    pel_put_u32x4(end - 4, v);
    pel_put_u32x4(p + 4, v);
    for (p += 8; p < end - 4; p += 8) {
        pel_prefetch((uintptr_t)p + ahead);
        pel_put_u32x4(p, v);
        pel_put_u32x4(p + 4, v);
    }
}

#else

typedef uint32_t pel_value32;

/* `blocks` >= 1 times 16 bytes of v, and where the next ones go. Arm stores
 * four registers with one instruction, which compilers do not find. */
#if defined(__arm__) && defined(__GNUC__)
static inline pel_word32 *pel_put_blocks(pel_word32 *q, int32_t blocks,
                                         uint32_t v)
{
    register uint32_t a __asm__("r3") = v;
    register uint32_t b __asm__("r4") = v;
    register uint32_t c __asm__("r5") = v;
    register uint32_t d __asm__("r6") = v;
    __asm__ volatile(".syntax unified\n"
                     "1:\tstmia %0!, {%2, %3, %4, %5}\n"
                     "\tsubs %1, #1\n"
                     "\tbne 1b"
                     : "+l"(q), "+l"(blocks)
                     : "l"(a), "l"(b), "l"(c), "l"(d)
                     : "cc", "memory");
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

static inline void pel_span32(pel_word32 *p, int32_t n, pel_value32 v,
                              uintptr_t ahead)
{
    (void)ahead;
    if (n <= 0)
        return;
    if (n >= 4)
        p = pel_put_blocks(p, n >> 2, v);
    for (n &= 3; n > 0; n--)
        *p++ = v;
}

#endif

static inline pel_value32 pel_make_value32(uint32_t pixel)
{
    return (pel_value32){0} + pixel;
}

#endif
