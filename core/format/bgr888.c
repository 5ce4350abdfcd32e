#include "formats.h"

static uint32_t pack(pel_color c)
{
    return pel_blue(c) << 16 | (c & 0xFF00u) | pel_red(c);
}

static pel_color unpack(uint32_t p)
{
    return PEL_RGB(pel_blue(p), pel_green(p), pel_red(p));
}

#include "body24.h"

const struct pel_format pel_bgr888 = {
    PEL_FORMAT_BGR888, 24, 1, pack, unpack, pel_fill24, blend, put, load,
};
