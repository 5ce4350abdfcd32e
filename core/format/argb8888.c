#include "argb8888.h"

#include "formats.h"
#include "word32.h"

static uint32_t pack(pel_color c)
{
    return PEL_LE32(UINT32_C(0xFF000000) | c);
}

static pel_color unpack(uint32_t p)
{
    return PEL_LE32(p);
}

static void blend(const struct pel_rows *rows, pel_color color)
{
    pel_xrgb8888.blend(rows, color);
}

static void put(const struct pel_surface *s, int32_t x, int32_t y, int32_t n,
                const pel_color *colors)
{
    pel_xrgb8888.put(s, x, y, n, colors);
}

static void load(const struct pel_surface *s, int32_t x, int32_t y, int32_t n,
                 pel_color *colors)
{
    pel_load32(pel_address32(s, x, y), n, colors, unpack);
}

const struct pel_format pel_argb8888 = {
    PEL_FORMAT_ARGB8888, 32, 4, pack, unpack, pel_fill32, blend, put, load,
};
