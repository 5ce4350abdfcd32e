#include "formats.h"

static uint32_t pack(pel_color c)
{
    return pel_gray(c);
}

static pel_color unpack(uint32_t p)
{
    return PEL_RGB(p, p, p);
}

#include "body8.h"

const struct pel_format pel_gray8 = {
    PEL_FORMAT_GRAY8, 8, 1, pack, unpack, pel_fill8, blend, put, load,
};
