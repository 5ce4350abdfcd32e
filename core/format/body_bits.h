/* The body of formats whose pixels of BITS bits lie side by side in a byte, the
 * left one in its high bits. A surface begins at a byte. */
#ifndef PEL_FORMAT_BODY_BITS_H
#define PEL_FORMAT_BODY_BITS_H

#include "packed.h"

typedef struct pel_place place;

static inline place at(const struct pel_surface *s, int32_t x, int32_t y)
{
    const uintptr_t bit = ((uintptr_t)x - (uintptr_t)s->bounds.x0) * BITS;
    const place p = {(uint8_t *)((uintptr_t)pel_surface_line(s, y) + bit / 8),
                     8 - BITS - (int)(bit & 7)};
    return p;
}

static inline place next(place p)
{
    p.shift = (p.shift - BITS) & 7;
    p.byte += p.shift == 8 - BITS;
    return p;
}

static inline uint32_t get(place p)
{
    return pel_place_get(p, BITS);
}

static inline void set(place p, uint32_t pixel)
{
    pel_place_set(p, pixel, BITS);
}

#include "body.h"

#endif
