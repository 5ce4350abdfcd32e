/* The body of formats whose pixel is a word of 32 bits. */
#ifndef PEL_FORMAT_BODY32_H
#define PEL_FORMAT_BODY32_H

#include "blend32.h"

typedef pel_word32 *place;

static inline place at(const struct pel_surface *s, int32_t x, int32_t y)
{
    return pel_address32(s, x, y);
}

static inline place next(place p)
{
    return p + 1;
}

static inline uint32_t get(const pel_word32 *p)
{
    return *p;
}

static inline void set(place p, uint32_t pixel)
{
    *p = (pel_word32)pixel;
}

#include "body.h"

static void blend32(const struct pel_spans *spans, pel_color color)
{
#if PEL_VECTORS
    pel_blend32_rows(spans, color);
#else
    blend(spans, color);
#endif
}

#endif
