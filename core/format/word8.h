/* Loops over pixels of 8 bits, for the formats whose pixel is one word. The
 * format's own pack and unpack are inlined into them. */
#ifndef PEL_FORMAT_WORD8_H
#define PEL_FORMAT_WORD8_H

#include "word.h"

/* In fill8.c. */
void pel_fill8(const struct pel_rows *rows, uint32_t pixel);

static inline pel_word8 *pel_address8(const struct pel_surface *s, int32_t x,
                                      int32_t y)
{
    return (pel_word8 *)(pel_column_zero(s, y, 1) + (uintptr_t)x);
}

/* One pixel, weighted by the color's alpha; a format's own pack and unpack are
 * inlined. */
static PEL_ALWAYS_INLINE void pel_over8(pel_word8 *p, pel_color color,
                                        pel_pack_function pack,
                                        pel_unpack_function unpack)
{
    const uint32_t alpha = pel_alpha(color);
    if (alpha == 255)
        *p = (pel_word8)pack(color);
    else if (alpha != 0)
        *p = (pel_word8)pack(pel_mix(unpack(*p), color, alpha));
}

typedef void pel_over8_function(pel_word8 *p, pel_color color);

static PEL_ALWAYS_INLINE void pel_blend8(const struct pel_rows *rows,
                                         pel_color color,
                                         pel_over8_function over)
{
    const struct pel_row *row = rows->row;
    int32_t y = rows->y;
    for (int32_t i = rows->n; i > 0; i--, row++, y += rows->step) {
        pel_word8 *p = pel_address8(rows->surface, row->x0, y);
        for (int32_t n = row->x1 - row->x0; n > 0; n--)
            over(p++, color);
    }
}

static PEL_ALWAYS_INLINE void pel_load8(const pel_word8 *p, int32_t n,
                                        pel_color *colors,
                                        pel_unpack_function unpack)
{
    for (; n > 0; n--)
        *colors++ = unpack(*p++);
}

#endif
