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

static PEL_ALWAYS_INLINE void pel_blend24(const struct pel_rows *rows,
                                          pel_color color,
                                          pel_pack_function pack,
                                          pel_unpack_function unpack)
{
    const struct pel_row *row = rows->row;
    const uint32_t alpha = pel_alpha(color);
    int32_t y = rows->y;
    for (int i = 0; i < rows->n; i++, row++, y += rows->step) {
        uint8_t *p = pel_address24(rows->surface, row->x0, y);
        for (int32_t n = row->x1 - row->x0; n > 0; n--, p += 3)
            pel_put24(p, pack(pel_mix(unpack(pel_get24(p)), color, alpha)));
    }
}

static PEL_ALWAYS_INLINE void pel_store24(uint8_t *p, int32_t n,
                                          const pel_color *colors,
                                          pel_pack_function pack)
{
    for (; n > 0; n--, p += 3)
        pel_put24(p, pack(*colors++));
}

static PEL_ALWAYS_INLINE void pel_load24(const uint8_t *p, int32_t n,
                                         pel_color *colors,
                                         pel_unpack_function unpack)
{
    for (; n > 0; n--, p += 3)
        *colors++ = unpack(pel_get24(p));
}

#endif
