#include "formats.h"
#include "word24.h"

static uint32_t pack(pel_color c)
{
    return pel_blue(c) << 16 | (c & 0xFF00u) | pel_red(c);
}

static pel_color unpack(uint32_t p)
{
    return PEL_RGB(pel_blue(p), pel_green(p), pel_red(p));
}

static void over(uint8_t *p, pel_color color)
{
    pel_over24(p, color, pack, unpack);
}

static void blend(const struct pel_rows *rows, pel_color color)
{
    pel_blend24(rows, color, over);
}

static void put(const struct pel_surface *s, int32_t x, int32_t y, int32_t n,
                const pel_color *colors)
{
    uint8_t *p = pel_address24(s, x, y);
    for (; n > 0; n--, p += 3)
        over(p, *colors++);
}

static void load(const struct pel_surface *s, int32_t x, int32_t y, int32_t n,
                 pel_color *colors)
{
    pel_load24(pel_address24(s, x, y), n, colors, unpack);
}

const struct pel_format pel_bgr888 = {
    PEL_FORMAT_BGR888, 24, 1, pack, unpack, pel_fill24, blend, put, load,
};
