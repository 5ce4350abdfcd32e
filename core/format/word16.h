/* Pixels that are a word of 16 bits. */
#ifndef PEL_FORMAT_WORD16_H
#define PEL_FORMAT_WORD16_H

#include "word.h"

/* In fill16.c. */
void pel_fill16(const struct pel_spans *spans, uint32_t pixel);

/* Of struct pel_dithering, in pattern16.c. */
void pel_pattern16(const struct pel_surface *s, int32_t x, int32_t y, int32_t n,
                   const uint32_t pixels[8]);

static inline pel_word16 *pel_address16(const struct pel_surface *s, int32_t x,
                                        int32_t y)
{
    return (pel_word16 *)(pel_column_zero(s, y, 2) + 2 * (uintptr_t)x);
}

#endif
