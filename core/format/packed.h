/* Pixels that share a byte with others. */
#ifndef PEL_FORMAT_PACKED_H
#define PEL_FORMAT_PACKED_H

#include "word.h"

/* Where a pixel is. */
struct pel_place {
    uint8_t *byte;
    int shift; /* of the pixel's bits from bit 0 */
};

/* Runs of gray4 and mono1, in fill_bits.c: `byte` is the pixel repeated over 8
 * bits. */
void pel_fill_bits(const struct pel_spans *spans, uint32_t byte);

#endif
