#include "formats.h"
#include "word.h"

static uint32_t pack(pel_color c)
{
    return PEL_LE32(PEL_RGB(pel_blue(c), pel_green(c), pel_red(c)));
}

static pel_color unpack(uint32_t p)
{
    p = PEL_LE32(p);
    return PEL_RGB(pel_blue(p), pel_green(p), pel_red(p));
}

#include "body32.h"

const struct pel_format pel_xbgr8888 = {
    PEL_FORMAT_XBGR8888, 32, 4, pack, unpack, pel_fill32, blend32, put, load,
};
