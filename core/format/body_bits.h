/* The body of formats whose pixels share a byte with others. The format finds
 * the place of a pixel (`at`), and says which bits are its own when they lie at
 * bit 0 (PIXEL). */
#ifndef PEL_FORMAT_BODY_BITS_H
#define PEL_FORMAT_BODY_BITS_H

#include "packed.h"

typedef struct pel_place place;

static inline uint32_t get(place p)
{
    return (uint32_t)*p.byte >> p.shift & PIXEL;
}

static inline void set(place p, uint32_t pixel)
{
    *p.byte = (uint8_t)((*p.byte & ~(PIXEL << p.shift)) | pixel << p.shift);
}

#include "body.h"

static void over_at(const struct pel_surface *s, int32_t x, int32_t y,
                    pel_color color)
{
    over(at(s, x, y), color);
}

static void blend(const struct pel_spans *spans, pel_color color)
{
    const struct pel_span *span = spans->span;
    int32_t y = spans->y;
    for (int32_t i = spans->n; i > 0; i--, span++, y += spans->step)
        for (int32_t x = span->x0; x < span->x1; x++)
            over_at(spans->surface, x, y, color);
}

static void put(const struct pel_surface *s, int32_t x, int32_t y, int32_t n,
                const pel_color *colors)
{
    for (; n > 0; n--)
        over_at(s, x++, y, *colors++);
}

static void load(const struct pel_surface *s, int32_t x, int32_t y, int32_t n,
                 pel_color *colors)
{
    for (; n > 0; n--)
        *colors++ = unpack(get(at(s, x++, y)));
}

#endif
