/* Pixels of 3 bytes, the lowest byte of the pixel value first. */
#ifndef PEL_FORMAT_WORD24_H
#define PEL_FORMAT_WORD24_H

#include "word.h"

/* In fill24.c. */
void pel_fill24(const struct pel_spans *spans, uint32_t pixel);

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

#endif
