#include "formats.h"
#include "word.h"

static uint32_t pack(pel_color c)
{
    return PEL_LE32(c << 8 | 0xFFu);
}

static pel_color unpack(uint32_t p)
{
    return UINT32_C(0xFF000000) | PEL_LE32(p) >> 8;
}

#include "body32.h"

const struct pel_format pel_rgbx8888 = {
    PEL_FORMAT_RGBX8888, 32, 4, pack, unpack, pel_fill32, blend32, put, load,
};
