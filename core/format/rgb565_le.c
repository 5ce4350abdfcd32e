#include "formats.h"
#include "rgb565.h"

static uint32_t pack(pel_color c)
{
    return PEL_LE16(pel_rgb565(c));
}

static pel_color unpack(uint32_t p)
{
    return pel_rgb565_color(PEL_LE16(p));
}

#include "body565.h"

const struct pel_format pel_rgb565_le = {
    PEL_FORMAT_RGB565_LE, 16,       2,      pack, unpack,
    pel_fill16,           blend565, put565, load,
};
