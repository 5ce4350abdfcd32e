#include "formats.h"
#include "packed.h"

static uint32_t pack(pel_color c)
{
    return pel_gray(c) >> 7;
}

static pel_color unpack(uint32_t p)
{
    return p ? PEL_RGB(255, 255, 255) : PEL_RGB(0, 0, 0);
}

static uint8_t *byte_of(const struct pel_surface *s, int32_t x, int32_t y)
{
    return pel_surface_line(s, y) + (x - s->bounds.x0) / 8;
}

/* bounds.x0 is a multiple of 8. */
static uint32_t mask_of(int32_t x)
{
    return 0x80u >> (x & 7);
}

static uint32_t get_pixel(const struct pel_surface *s, int32_t x, int32_t y)
{
    return (*byte_of(s, x, y) & mask_of(x)) != 0;
}

static void put_pixel(const struct pel_surface *s, int32_t x, int32_t y,
                      uint32_t p)
{
    uint8_t *byte = byte_of(s, x, y);
    *byte = (uint8_t)(p ? *byte | mask_of(x) : *byte & ~mask_of(x));
}

static void fill(const struct pel_rows *rows, uint32_t pixel)
{
    pel_fill_bits(rows, pixel ? 0xFFu : 0u);
}

static void over(const struct pel_surface *s, int32_t x, int32_t y,
                 pel_color color)
{
    const uint32_t alpha = pel_alpha(color);
    if (alpha == 255)
        put_pixel(s, x, y, pack(color));
    else if (alpha != 0)
        put_pixel(s, x, y,
                  pack(pel_mix(unpack(get_pixel(s, x, y)), color, alpha)));
}

static void blend(const struct pel_rows *rows, pel_color color)
{
    pel_blend_packed(rows, color, over);
}

static void put(const struct pel_surface *s, int32_t x, int32_t y, int32_t n,
                const pel_color *colors)
{
    for (; n > 0; n--)
        over(s, x++, y, *colors++);
}

static void load(const struct pel_surface *s, int32_t x, int32_t y, int32_t n,
                 pel_color *colors)
{
    for (; n > 0; n--)
        *colors++ = unpack(get_pixel(s, x++, y));
}

const struct pel_format pel_mono1 = {
    PEL_FORMAT_MONO1, 1, 1, pack, unpack, fill, blend, put, load,
};
