/* Pixels that are a word of 32 bits. */
#ifndef PEL_FORMAT_WORD32_H
#define PEL_FORMAT_WORD32_H

#include "word.h"

/* In fill32.c. */
void pel_fill32(const struct pel_spans *spans, uint32_t pixel);

static inline pel_word32 *pel_address32(const struct pel_surface *s, int32_t x,
                                        int32_t y)
{
    return (pel_word32 *)(pel_column_zero(s, y, 4) + 4 * (uintptr_t)x);
}

#endif
