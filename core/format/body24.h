/* The body of formats whose pixel is three bytes. */
#ifndef PEL_FORMAT_BODY24_H
#define PEL_FORMAT_BODY24_H

#include "word24.h"

typedef struct {
    uint8_t bytes[3];
} * place;

static inline place at(const struct pel_surface *s, int32_t x, int32_t y)
{
    return (place)pel_address24(s, x, y);
}

static inline place next(place p)
{
    return p + 1;
}

static inline uint32_t get(place p)
{
    return pel_get24(p->bytes);
}

static inline void set(place p, uint32_t pixel)
{
    pel_put24(p->bytes, pixel);
}

#include "body.h"

#endif
