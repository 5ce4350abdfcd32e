/* Memory of pixels: words that may alias the caller's array, byte order, and
 * the address of a pixel. */
#ifndef PEL_FORMAT_WORD_H
#define PEL_FORMAT_WORD_H

#include "../base/surface.h"

typedef uint8_t pel_word8;
typedef uint16_t PEL_MAY_ALIAS pel_word16;
typedef uint32_t PEL_MAY_ALIAS pel_word32;

#ifdef __GNUC__
/* One instruction on Arm, which compilers do not find in the shifts. On Thumb-1
 * they must not see it: they would take channels from the bytes before the
 * swap, with masks for which there are no registers. */
static inline uint32_t pel_swap16(uint32_t v)
{
#if defined(__thumb__) && !defined(__thumb2__) && __ARM_ARCH >= 6
    __asm__("rev16 %0, %0" : "+l"(v));
    return v & 0xFFFF;
#else
    return __builtin_bswap16(PEL_CAST(uint16_t, v));
#endif
}

/* Asks for a cache line that is soon written. The address need not be in
 * memory. (Always inlined: gcc takes a function that only prefetches for an
 * empty one.) */
static PEL_ALWAYS_INLINE void pel_prefetch(uintptr_t address)
{
    if (PEL_64BIT)
        __builtin_prefetch(PEL_CAST_ADDRESS(const void *, address), 1);
}
#else
static inline uint32_t pel_swap16(uint32_t v)
{
    return (v << 8 & 0xFF00u) | (v >> 8 & 0xFFu);
}

static inline void pel_prefetch(uintptr_t address)
{
    (void)address;
}
#endif

/* pel_prefetch is asked for memory so many rows below the one that is written.
 */
enum { PEL_ROWS_AHEAD = 4 };

static inline uint32_t pel_swap32(uint32_t v)
{
    return pel_swap16(v) << 16 | pel_swap16(v >> 16);
}

/* The CPU's value of a word whose bytes in memory are little-endian, and back;
 * big-endian likewise. */
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
#define PEL_LE16(v) pel_swap16(v)
#define PEL_BE16(v) (v)
#define PEL_LE32(v) pel_swap32(v)
#else
#define PEL_LE16(v) (v)
#define PEL_BE16(v) pel_swap16(v)
#define PEL_LE32(v) (v)
#endif

/* n bits to 8 by repeating them from the top: 0 stays 0, all ones give 255. */
static PEL_ALWAYS_INLINE uint32_t pel_widen(uint32_t v, int bits)
{
    for (; bits < 8; bits *= 2)
        v |= v << bits;
    return v >> (bits - 8);
}

/* The address that column 0 of row y has or would have, pixels being `bytes`
 * wide. Addresses are counted from there as numbers, not as pointers: neither
 * column 0 nor an empty span need lie in memory. */
static inline uintptr_t pel_column_zero(const struct pel_surface *s, int32_t y,
                                        int bytes)
{
    return PEL_CAST_ADDRESS(uintptr_t, pel_surface_line(s, y)) -
           PEL_CAST(uintptr_t, bytes * PEL_CAST(ptrdiff_t, s->bounds.x0));
}

/* Bytes from the row of a span to that of the next. */
static inline ptrdiff_t pel_spans_pitch(const struct pel_spans *spans)
{
    return PEL_CAST(ptrdiff_t, spans->surface->stride) * spans->step;
}

/* The address of pixel (x, y), pixels being `bytes` wide. */
static inline uintptr_t pel_address(const struct pel_surface *s, int32_t x,
                                    int32_t y, int bytes)
{
    return pel_column_zero(s, y, bytes) +
           PEL_CAST(uintptr_t, bytes) * PEL_CAST(uintptr_t, x);
}

static PEL_SHARED pel_word16 *pel_address16(const struct pel_surface *s,
                                            int32_t x, int32_t y)
{
    return PEL_CAST_ADDRESS(pel_word16 *, pel_address(s, x, y, 2));
}

static inline pel_word32 *pel_address32(const struct pel_surface *s, int32_t x,
                                        int32_t y)
{
    return PEL_CAST_ADDRESS(pel_word32 *, pel_address(s, x, y, 4));
}

PEL_BEGIN_DECLS

/* The fill of formats with pixels of 8, 16, 24 and 32 bits. */
void pel_fill8(const struct pel_spans *spans, uint32_t pixel);
void pel_fill16(const struct pel_spans *spans, uint32_t pixel);
void pel_fill24(const struct pel_spans *spans, uint32_t pixel);
void pel_fill32(const struct pel_spans *spans, uint32_t pixel);

/* Spans of gray4, gray2, inks2 and mono1; `byte` is the pixel repeated over 8
 * bits. */
void pel_fill_bits(const struct pel_spans *spans, uint32_t byte);

/* Blends spans of pixels of one bit. */
void pel_blend_mono(const struct pel_spans *spans, pel_color color);
PEL_END_DECLS

#endif
