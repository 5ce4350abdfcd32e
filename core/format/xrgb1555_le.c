#include "formats.h"
#include "word16.h"

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

static void over(pel_word16 *p, pel_color color)
{
    pel_over16(p, color, pack, unpack);
}

static void blend(const struct pel_rows *rows, pel_color color)
{
    pel_blend16(rows, color, over);
}

static void put(const struct pel_surface *s, int32_t x, int32_t y, int32_t n,
                const pel_color *colors)
{
    pel_word16 *p = pel_address16(s, x, y);
    for (; n > 0; n--, p++)
        over(p, *colors++);
}

static void load(const struct pel_surface *s, int32_t x, int32_t y, int32_t n,
                 pel_color *colors)
{
    pel_load16(pel_address16(s, x, y), n, colors, unpack);
}

const struct pel_format pel_xrgb1555_le = {
    PEL_FORMAT_XRGB1555_LE, 16, 2, pack, unpack, pel_fill16, blend, put, load,
};
