/* Pixels that are a word of 8 bits. */
#ifndef PEL_FORMAT_WORD8_H
#define PEL_FORMAT_WORD8_H

#include "word.h"

/* In fill8.c. */
void pel_fill8(const struct pel_spans *spans, uint32_t pixel);

static inline pel_word8 *pel_address8(const struct pel_surface *s, int32_t x,
                                      int32_t y)
{
    return (pel_word8 *)(pel_column_zero(s, y, 1) + (uintptr_t)x);
}

#endif
