/* Pixels that share a byte with others. */
#ifndef PEL_FORMAT_PACKED_H
#define PEL_FORMAT_PACKED_H

#include "word.h"

/* The place of a pixel. */
struct pel_place {
    uint8_t *byte;
    int shift; /* of the pixel's bits from bit 0 */
};

static inline uint32_t pel_place_get(struct pel_place p, int bits)
{
    return (uint32_t)*p.byte >> p.shift & ((1u << bits) - 1);
}

static inline void pel_place_set(struct pel_place p, uint32_t pixel, int bits)
{
    const uint32_t mask = ((1u << bits) - 1) << p.shift;
    *p.byte = (uint8_t)((*p.byte & ~mask) | pixel << p.shift);
}

/* Spans of gray4 and mono1, in fill_bits.c: `byte` is the pixel repeated over 8
 * bits. */
void pel_fill_bits(const struct pel_spans *spans, uint32_t byte);

/* Blends spans of pixels of one bit, in blend_mono.c. */
void pel_blend_mono(const struct pel_spans *spans, pel_color color);

#endif
