#include "formats.h"

static uint32_t pack(pel_color c)
{
    return (c >> 16 & 0xE0u) | (c >> 11 & 0x1Cu) | (c >> 6 & 0x03u);
}

static pel_color unpack(uint32_t p)
{
    uint32_t r = p >> 5, g = p >> 2 & 7, b = p & 3;
    return PEL_RGB(r << 5 | r << 2 | r >> 1, g << 5 | g << 2 | g >> 1,
                   b * 0x55u);
}

#include "body8.h"

const struct pel_format pel_rgb332 = {
    PEL_FORMAT_RGB332, 8, 1, pack, unpack, pel_fill8, blend, put, load,
};
