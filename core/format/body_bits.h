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

static void blend(const struct pel_rows *rows, pel_color color)
{
    const struct pel_row *row = rows->row;
    int32_t y = rows->y;
    for (int32_t i = rows->n; i > 0; i--, row++, y += rows->step)
        for (int32_t x = row->x0; x < row->x1; x++)
            over_at(rows->surface, x, y, color);
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
