#include "formats.h"
#include "packed.h"

#define PIXEL 1u

static uint32_t pack(pel_color c)
{
    return pel_gray(c) >> 7;
}

static pel_color unpack(uint32_t p)
{
    return p ? PEL_RGB(255, 255, 255) : PEL_RGB(0, 0, 0);
}

/* bounds.x0 is a multiple of 8. */
static struct pel_place at(const struct pel_surface *s, int32_t x, int32_t y)
{
    const struct pel_place p = {pel_surface_line(s, y) + (x - s->bounds.x0) / 8,
                                7 - (x & 7)};
    return p;
}

#include "body_bits.h"

static void fill(const struct pel_spans *spans, uint32_t pixel)
{
    pel_fill_bits(spans, pixel ? 0xFFu : 0u);
}

const struct pel_format pel_mono1 = {
    PEL_FORMAT_MONO1, 1, 1, pack, unpack, fill, blend, put, load,
};
