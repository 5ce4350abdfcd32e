/* Colours into runs of 5-6-5 pixels, eight at a time. Only where PEL_VECTORS is
 * 1, that is on little-endian CPUs. */
#ifndef PEL_FORMAT_PUT565_H
#define PEL_FORMAT_PUT565_H

#include "vector.h"

#if PEL_VECTORS

/* Stores eights of opaque colours and stops before the first that has another,
 * or before the last few of n: how many were stored. */
int32_t pel_put565_opaque(const struct pel_format *format, pel_word16 *p,
                          int32_t n, const pel_color *colors);

#endif
#endif
