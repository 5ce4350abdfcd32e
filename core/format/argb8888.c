#include "argb8888.h"

#include "word.h"

static PEL_HOT uint32_t pack(pel_color c)
{
    return PEL_LE32(UINT32_C(0xFF000000) | c);
}

static PEL_HOT pel_color unpack(uint32_t p)
{
    return PEL_LE32(p);
}

static inline uint32_t blended(uint32_t p, const struct pel_premultiplied *s)
{
    return pack(pel_over(unpack(p), s));
}

#define PUT (PEL_VECTORS ? pel_put32 : put)
#include "body32.inc"

const struct pel_format pel_argb8888 = {
    .id = PEL_FORMAT_ARGB8888,
    FORMAT_32,
};
