/* Pixels of red, green and blue in 5, 6 and 5 bits, as a number. */
#ifndef PEL_FORMAT_RGB565_H
#define PEL_FORMAT_RGB565_H

#include "word.h"

static PEL_ALWAYS_INLINE uint32_t pel_rgb565(pel_color c)
{
    return (c >> 8 & 0xF800u) | (c >> 5 & 0x07E0u) | (c >> 3 & 0x001Fu);
}

static PEL_ALWAYS_INLINE pel_color pel_rgb565_color(uint32_t p)
{
    return PEL_RGB(pel_widen5(p >> 11), pel_widen6(p >> 5 & 63),
                   pel_widen5(p & 31));
}

#endif
