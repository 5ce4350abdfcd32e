#include "formats.h"

static uint32_t pack(pel_color c)
{
    return c & UINT32_C(0xFFFFFF);
}

static pel_color unpack(uint32_t p)
{
    return UINT32_C(0xFF000000) | p;
}

#include "body24.h"

const struct pel_format pel_rgb888 = {
    PEL_FORMAT_RGB888, 24, 1, pack, unpack, pel_fill24, blend, put, load,
};
