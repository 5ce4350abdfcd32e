/* What the hit tests begin with. */
#ifndef PEL_HIT_HIT_PIXEL_H
#define PEL_HIT_HIT_PIXEL_H

#include "../base/point.h"

/* Pixel (x, y) as the place of its centre; false when out of range. */
static inline bool pel_hit_pixel(int32_t x, int32_t y, struct pel_point *p)
{
    if ((((uint32_t)x + 32768u) | ((uint32_t)y + 32768u)) >> 16)
        return false;
    p->x = pel_pixel_center(x);
    p->y = pel_pixel_center(y);
    return true;
}

/* In the closed disc? Most pixels are outside of its square. */
static inline bool pel_hit_disc(struct pel_point p, struct pel_point center,
                                int32_t radius)
{
    const int32_t dx = p.x - center.x, dy = p.y - center.y;
    return dx <= radius && dx >= -radius && dy <= radius && dy >= -radius &&
           pel_square(dx) + pel_square(dy) <= pel_square(radius);
}

/* In the range of angles around the centre? Rule: round/wedge.h. */
bool pel_hit_wedge(struct pel_point center, uint16_t from, uint16_t to,
                   struct pel_point p);

#endif
