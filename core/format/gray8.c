#include "formats.h"
#include "word8.h"

static uint32_t pack(pel_color c)
{
    return pel_gray(c);
}

static pel_color unpack(uint32_t p)
{
    return PEL_RGB(p, p, p);
}

static void over(pel_word8 *p, pel_color color)
{
    pel_over8(p, color, pack, unpack);
}

static void blend(const struct pel_rows *rows, pel_color color)
{
    pel_blend8(rows, color, over);
}

static void put(const struct pel_surface *s, int32_t x, int32_t y, int32_t n,
                const pel_color *colors)
{
    pel_word8 *p = pel_address8(s, x, y);
    for (; n > 0; n--, p++)
        over(p, *colors++);
}

static void load(const struct pel_surface *s, int32_t x, int32_t y, int32_t n,
                 pel_color *colors)
{
    pel_load8(pel_address8(s, x, y), n, colors, unpack);
}

const struct pel_format pel_gray8 = {
    PEL_FORMAT_GRAY8, 8, 1, pack, unpack, pel_fill8, blend, put, load,
};
