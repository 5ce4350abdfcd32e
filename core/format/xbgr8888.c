#include "blend32.h"
#include "formats.h"

static uint32_t pack(pel_color c)
{
    return PEL_LE32(PEL_RGB(pel_blue(c), pel_green(c), pel_red(c)));
}

static pel_color unpack(uint32_t p)
{
    p = PEL_LE32(p);
    return PEL_RGB(pel_blue(p), pel_green(p), pel_red(p));
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

const struct pel_format pel_xbgr8888 = {
    PEL_FORMAT_XBGR8888, 32, 4, pack, unpack, pel_fill32, blend, put, load,
};
