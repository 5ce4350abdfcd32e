/* Loops over pixels of 16 bits, for the formats whose pixel is one word. The
 * format's own pack and unpack are inlined into them. */
#ifndef PEL_FORMAT_WORD16_H
#define PEL_FORMAT_WORD16_H

#include "word.h"

/* In fill16.c. */
void pel_fill16(const struct pel_rows *rows, uint32_t pixel);

static inline pel_word16 *pel_address16(const struct pel_surface *s, int32_t x,
                                        int32_t y)
{
    return (pel_word16 *)(pel_column_zero(s, y, 2) + 2 * (uintptr_t)x);
}

/* One pixel, weighted by the color's alpha; a format's own pack and unpack are
 * inlined. */
static PEL_ALWAYS_INLINE void pel_over16(pel_word16 *p, pel_color color,
                                         pel_pack_function pack,
                                         pel_unpack_function unpack)
{
    const uint32_t alpha = pel_alpha(color);
    if (alpha == 255)
        *p = (pel_word16)pack(color);
    else if (alpha != 0)
        *p = (pel_word16)pack(pel_mix(unpack(*p), color, alpha));
}

typedef void pel_over16_function(pel_word16 *p, pel_color color);

static PEL_ALWAYS_INLINE void pel_blend16(const struct pel_rows *rows,
                                          pel_color color,
                                          pel_over16_function over)
{
    const struct pel_row *row = rows->row;
    int32_t y = rows->y;
    for (int32_t i = rows->n; i > 0; i--, row++, y += rows->step) {
        pel_word16 *p = pel_address16(rows->surface, row->x0, y);
        for (int32_t n = row->x1 - row->x0; n > 0; n--)
            over(p++, color);
    }
}

static PEL_ALWAYS_INLINE void pel_load16(const pel_word16 *p, int32_t n,
                                         pel_color *colors,
                                         pel_unpack_function unpack)
{
    for (; n > 0; n--)
        *colors++ = unpack(*p++);
}

#endif
