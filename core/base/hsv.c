#include "color.h"

/* round(v (255 turn - s part) / (255 turn)), part <= turn <= 65,536: the sum is
 * less than 2^32. */
static uint32_t level(uint32_t v, uint32_t s, uint32_t part, uint32_t turn)
{
    uint32_t whole = 255 * turn;
    return (v * (whole - s * part) + whole / 2) / whole;
}

/* The sixth of the turn, 0..5, and the part of it, 0 <= part < turn. */
static pel_color sixth_color(uint32_t sixth, uint32_t part, uint32_t turn,
                             uint32_t s, uint32_t v)
{
    const uint32_t p = level(v, s, turn, turn);
    const uint32_t between = level(v, s, sixth & 1 ? part : turn - part, turn);
    const uint32_t levels[3] = {v, between, p};
    static const uint8_t of_channel[6][3] = {{0, 1, 2}, {1, 0, 2}, {2, 0, 1},
                                             {2, 1, 0}, {1, 2, 0}, {0, 2, 1}};
    const uint8_t *k = of_channel[sixth];
    return PEL_RGB(levels[k[0]], levels[k[1]], levels[k[2]]);
}

pel_color pel_hsv(int32_t hue, uint32_t s, uint32_t v)
{
    uint32_t six = ((uint32_t)hue & 0xFFFFu) * 6;
    return sixth_color(six >> 16, six & 0xFFFFu, 65536, s, v);
}

pel_color pel_hsv_degrees(int32_t hue, uint32_t s, uint32_t v)
{
    int32_t degrees = hue % 360;
    if (degrees < 0)
        degrees += 360;
    return sixth_color((uint32_t)degrees / 60, (uint32_t)degrees % 60, 60, s,
                       v);
}
