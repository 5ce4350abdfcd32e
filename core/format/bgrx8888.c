#include "formats.h"
#include "word.h"

static uint32_t pack(pel_color c)
{
    return PEL_LE32(pel_blue(c) << 24 | pel_green(c) << 16 | pel_red(c) << 8 |
                    0xFFu);
}

static pel_color unpack(uint32_t p)
{
    p = PEL_LE32(p);
    return PEL_RGB(p >> 8 & 255, p >> 16 & 255, p >> 24);
}

#include "body32.h"

const struct pel_format pel_bgrx8888 = {
    PEL_FORMAT_BGRX8888, 32, 4, pack, unpack, pel_fill32, blend32, put, load,
};
