/* The body of formats whose pixel is a word of 16 bits. */
#ifndef PEL_FORMAT_BODY16_H
#define PEL_FORMAT_BODY16_H

#include "word16.h"

typedef pel_word16 *place;

static inline place at(const struct pel_surface *s, int32_t x, int32_t y)
{
    return pel_address16(s, x, y);
}

static inline place next(place p)
{
    return p + 1;
}

static inline uint32_t get(const pel_word16 *p)
{
    return *p;
}

static inline void set(place p, uint32_t pixel)
{
    *p = (pel_word16)pixel;
}

#include "body.h"

#endif
