#include "blend565.h"
#include "formats.h"

static uint32_t pack(pel_color c)
{
    return PEL_BE16((c >> 8 & 0xF800u) | (c >> 5 & 0x07E0u) |
                    (c >> 3 & 0x001Fu));
}

static pel_color unpack(uint32_t p)
{
    p = PEL_BE16(p);
    return PEL_RGB(pel_widen5(p >> 11), pel_widen6(p >> 5 & 63),
                   pel_widen5(p & 31));
}

static void over(pel_word16 *p, pel_color color)
{
    pel_over16(p, color, pack, unpack);
}

static void blend(const struct pel_rows *rows, pel_color color)
{
    pel_blend565(rows, color, over);
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

const struct pel_format pel_rgb565_be = {
    PEL_FORMAT_RGB565_BE, 16, 2, pack, unpack, pel_fill16, blend, put, load,
};
