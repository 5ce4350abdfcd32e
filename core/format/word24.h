/* Loops over pixels of 3 bytes, the lowest byte of the pixel value first. */
#ifndef PEL_FORMAT_WORD24_H
#define PEL_FORMAT_WORD24_H

#include "word.h"

/* In fill24.c. */
void pel_fill24(const struct pel_rows *rows, uint32_t pixel);

static inline uint8_t *pel_address24(const struct pel_surface *s, int32_t x,
                                     int32_t y)
{
    return (uint8_t *)(pel_column_zero(s, y, 3) + 3 * (uintptr_t)x);
}

static inline uint32_t pel_get24(const uint8_t *p)
{
    return (uint32_t)p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16;
}

static inline void pel_put24(uint8_t *p, uint32_t pixel)
{
    p[0] = (uint8_t)pixel;
    p[1] = (uint8_t)(pixel >> 8);
    p[2] = (uint8_t)(pixel >> 16);
}

/* One pixel, weighted by the color's alpha; a format's own pack and unpack are
 * inlined. */
static PEL_ALWAYS_INLINE void pel_over24(uint8_t *p, pel_color color,
                                         pel_pack_function pack,
                                         pel_unpack_function unpack)
{
    const uint32_t alpha = pel_alpha(color);
    if (alpha == 255)
        pel_put24(p, pack(color));
    else if (alpha != 0)
        pel_put24(p, pack(pel_mix(unpack(pel_get24(p)), color, alpha)));
}

typedef void pel_over24_function(uint8_t *p, pel_color color);

static PEL_ALWAYS_INLINE void pel_blend24(const struct pel_rows *rows,
                                          pel_color color,
                                          pel_over24_function over)
{
    const struct pel_row *row = rows->row;
    int32_t y = rows->y;
    for (int32_t i = rows->n; i > 0; i--, row++, y += rows->step) {
        uint8_t *p = pel_address24(rows->surface, row->x0, y);
        for (int32_t n = row->x1 - row->x0; n > 0; n--, p += 3)
            over(p, color);
    }
}

static PEL_ALWAYS_INLINE void pel_load24(const uint8_t *p, int32_t n,
                                         pel_color *colors,
                                         pel_unpack_function unpack)
{
    for (; n > 0; n--, p += 3)
        *colors++ = unpack(pel_get24(p));
}

#endif
