#include "color.h"

pel_color pel_hsv(int32_t hue, uint32_t s, uint32_t v)
{
    const uint32_t six = ((uint32_t)hue & 0xFFFFu) * 6;
    return pel_hsv_sixth(six >> 16, six & 0xFFFFu, 65536, s, v);
}

pel_color pel_hsv_degrees(int32_t hue, uint32_t s, uint32_t v)
{
    int32_t degrees = hue % 360;
    if (degrees < 0)
        degrees += 360;
    return pel_hsv_sixth((uint32_t)degrees / 60, (uint32_t)degrees % 60, 60, s,
                         v);
}
