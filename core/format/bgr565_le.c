#include "formats.h"
#include "word.h"

static uint32_t pack(pel_color c)
{
    return PEL_LE16((c << 8 & 0xF800u) | (c >> 5 & 0x07E0u) |
                    (c >> 19 & 0x001Fu));
}

static pel_color unpack(uint32_t p)
{
    p = PEL_LE16(p);
    return PEL_RGB(pel_widen5(p & 31), pel_widen6(p >> 5 & 63),
                   pel_widen5(p >> 11));
}

#include "body565.h"

const struct pel_format pel_bgr565_le = {
    PEL_FORMAT_BGR565_LE, 16,       2,      pack, unpack,
    pel_fill16,           blend565, put565, load,
};
