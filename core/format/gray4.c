#include "formats.h"
#include "packed.h"

#define PIXEL 15u

static uint32_t pack(pel_color c)
{
    return pel_gray(c) >> 4;
}

static pel_color unpack(uint32_t p)
{
    return PEL_RGB(p * 0x11u, p * 0x11u, p * 0x11u);
}

/* bounds.x0 is even. */
static struct pel_place at(const struct pel_surface *s, int32_t x, int32_t y)
{
    const struct pel_place p = {pel_surface_line(s, y) + (x - s->bounds.x0) / 2,
                                x & 1 ? 0 : 4};
    return p;
}

#include "body_bits.h"

static void fill(const struct pel_spans *spans, uint32_t pixel)
{
    pel_fill_bits(spans, pixel * 0x11u);
}

const struct pel_format pel_gray4 = {
    PEL_FORMAT_GRAY4, 4, 1, pack, unpack, fill, blend, put, load,
};
