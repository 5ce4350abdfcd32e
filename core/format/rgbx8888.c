#include "blend32.h"
#include "formats.h"

static uint32_t pack(pel_color c)
{
    return PEL_LE32(c << 8 | 0xFFu);
}

static pel_color unpack(uint32_t p)
{
    return UINT32_C(0xFF000000) | PEL_LE32(p) >> 8;
}

static void over(pel_word32 *p, pel_color color)
{
    pel_over32(p, color, pack, unpack);
}

static void blend(const struct pel_rows *rows, pel_color color)
{
    pel_blend32(rows, color, over);
}

static void put(const struct pel_surface *s, int32_t x, int32_t y, int32_t n,
                const pel_color *colors)
{
    pel_word32 *p = pel_address32(s, x, y);
    for (; n > 0; n--, p++)
        over(p, *colors++);
}

static void load(const struct pel_surface *s, int32_t x, int32_t y, int32_t n,
                 pel_color *colors)
{
    pel_load32(pel_address32(s, x, y), n, colors, unpack);
}

const struct pel_format pel_rgbx8888 = {
    PEL_FORMAT_RGBX8888, 32, 4, pack, unpack, pel_fill32, blend, put, load,
};
