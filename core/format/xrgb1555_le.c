#include "formats.h"
#include "word.h"

static uint32_t pack(pel_color c)
{
    return PEL_LE16(0x8000u | (c >> 9 & 0x7C00u) | (c >> 6 & 0x03E0u) |
                    (c >> 3 & 0x001Fu));
}

static pel_color unpack(uint32_t p)
{
    p = PEL_LE16(p);
    return PEL_RGB(pel_widen5(p >> 10 & 31), pel_widen5(p >> 5 & 31),
                   pel_widen5(p & 31));
}

#include "body16.h"

const struct pel_format pel_xrgb1555_le = {
    PEL_FORMAT_XRGB1555_LE, 16, 2, pack, unpack, pel_fill16, blend, put, load,
};
