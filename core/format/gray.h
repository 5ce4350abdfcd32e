/* Pixels of some bits of grey. */
#ifndef PEL_FORMAT_GRAY_H
#define PEL_FORMAT_GRAY_H

#include "word.h"

/* Grey is mixed as the color that it stands for. */
static PEL_ALWAYS_INLINE uint32_t
pel_gray_over(uint32_t pixel, const struct pel_premultiplied *s, int bits)
{
    const uint32_t d = pel_widen(pixel, bits) * s->rest;
    const uint32_t gray =
        pel_luma((d + s->red) >> 16, (d + s->green) >> 16, (d + s->blue) >> 16);
    return gray >> (8 - bits);
}

#endif
