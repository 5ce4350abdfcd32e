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

/* bounds.y0 is a multiple of 8. */
static struct pel_place at(const struct pel_surface *s, int32_t x, int32_t y)
{
    const struct pel_place p = {(uint8_t *)s->pixels +
                                    (ptrdiff_t)((y - s->bounds.y0) / 8) *
                                        (ptrdiff_t)s->stride +
                                    (x - s->bounds.x0),
                                y & 7};
    return p;
}

#include "body_bits.h"

static void fill(const struct pel_spans *spans, uint32_t pixel)
{
    const struct pel_span *span = spans->span;
    int32_t y = spans->y;
    for (int i = 0; i < spans->n; i++, span++, y += spans->step)
        for (int32_t x = span->x0; x < span->x1; x++)
            set(at(spans->surface, x, y), pixel);
}

const struct pel_format pel_mono1_pages = {
    PEL_FORMAT_MONO1_PAGES, 1, 1, pack, unpack, fill, blend, put, load,
};
