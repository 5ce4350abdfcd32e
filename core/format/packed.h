/* Loops over pixels that share a byte with others. */
#ifndef PEL_FORMAT_PACKED_H
#define PEL_FORMAT_PACKED_H

#include "word.h"

/* Runs of gray4 and mono1, in fill_bits.c: `byte` is the pixel repeated over 8
 * bits. */
void pel_fill_bits(const struct pel_rows *rows, uint32_t byte);

/* One pixel, weighted by the color's alpha. */
typedef void pel_over_function(const struct pel_surface *, int32_t x, int32_t y,
                               pel_color color);

static PEL_ALWAYS_INLINE void pel_blend_packed(const struct pel_rows *rows,
                                               pel_color color,
                                               pel_over_function over)
{
    const struct pel_row *row = rows->row;
    int32_t y = rows->y;
    for (int32_t i = rows->n; i > 0; i--, row++, y += rows->step)
        for (int32_t x = row->x0; x < row->x1; x++)
            over(rows->surface, x, y, color);
}

#endif
