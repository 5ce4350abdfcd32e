/* 16-byte vectors of GNU C, loaded and stored at any address through memcpy.
 * Only where PEL_VECTORS is 1. */
#ifndef PEL_FORMAT_VECTOR_H
#define PEL_FORMAT_VECTOR_H

#include <string.h>

#include "word.h"

#if PEL_VECTORS

typedef uint32_t pel_u32x4 __attribute__((__vector_size__(16)));
typedef uint16_t pel_u16x8 __attribute__((__vector_size__(16)));

static inline void pel_put_u32x4(void *p, pel_u32x4 v)
{
    memcpy(p, &v, 16);
}

static inline pel_u16x8 pel_get_u16x8(const void *p)
{
    pel_u16x8 v;
    memcpy(&v, p, 16);
    return v;
}

static inline void pel_put_u16x8(void *p, pel_u16x8 v)
{
    memcpy(p, &v, 16);
}

#endif
#endif
