/* The body of formats whose pixel is a word of 8 bits. */
#ifndef PEL_FORMAT_BODY8_H
#define PEL_FORMAT_BODY8_H

#include "word8.h"

typedef pel_word8 *place;

static inline place at(const struct pel_surface *s, int32_t x, int32_t y)
{
    return pel_address8(s, x, y);
}

static inline place next(place p)
{
    return p + 1;
}

static inline uint32_t get(const pel_word8 *p)
{
    return *p;
}

static inline void set(place p, uint32_t pixel)
{
    *p = (pel_word8)pixel;
}

#include "body.h"

#endif
