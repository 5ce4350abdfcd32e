/* Loops over pixels of 32 bits, for the formats whose pixel is one word. The
 * format's own pack and unpack are inlined into them. */
#ifndef PEL_FORMAT_WORD32_H
#define PEL_FORMAT_WORD32_H

#include "word.h"

/* In fill32.c. */
void pel_fill32(const struct pel_rows *rows, uint32_t pixel);

static inline pel_word32 *pel_address32(const struct pel_surface *s, int32_t x,
                                        int32_t y)
{
    return (pel_word32 *)(pel_column_zero(s, y, 4) + 4 * (uintptr_t)x);
}

/* One pixel, weighted by the color's alpha; a format's own pack and unpack are
 * inlined. */
static PEL_ALWAYS_INLINE void pel_over32(pel_word32 *p, pel_color color,
                                         pel_pack_function pack,
                                         pel_unpack_function unpack)
{
    const uint32_t alpha = pel_alpha(color);
    if (alpha == 255)
        *p = (pel_word32)pack(color);
    else if (alpha != 0)
        *p = (pel_word32)pack(pel_mix(unpack(*p), color, alpha));
}

typedef void pel_over32_function(pel_word32 *p, pel_color color);

static PEL_ALWAYS_INLINE void pel_blend_words32(const struct pel_rows *rows,
                                                pel_color color,
                                                pel_over32_function over)
{
    const struct pel_row *row = rows->row;
    int32_t y = rows->y;
    for (int32_t i = rows->n; i > 0; i--, row++, y += rows->step) {
        pel_word32 *p = pel_address32(rows->surface, row->x0, y);
        for (int32_t n = row->x1 - row->x0; n > 0; n--)
            over(p++, color);
    }
}

static PEL_ALWAYS_INLINE void pel_load32(const pel_word32 *p, int32_t n,
                                         pel_color *colors,
                                         pel_unpack_function unpack)
{
    for (; n > 0; n--)
        *colors++ = unpack(*p++);
}

#endif
