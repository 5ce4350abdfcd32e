#include "formats.h"
#include "packed.h"

#define BITS 1
#include "gray.inc"

typedef struct pel_place place;

/* bounds.y0 is a multiple of 8. */
static place at(const struct pel_surface *s, int32_t x, int32_t y)
{
    const uintptr_t column = (uintptr_t)x - (uintptr_t)s->bounds.x0;
    const ptrdiff_t page = (ptrdiff_t)((y - s->bounds.y0) / 8) * s->stride;
    const place p = {
        (uint8_t *)((uintptr_t)s->pixels + (uintptr_t)page + column), y & 7};
    return p;
}

static inline place next(place p)
{
    p.byte++;
    return p;
}

static inline uint32_t get(place p)
{
    return pel_place_get(p, BITS);
}

static inline void set(place p, uint32_t pixel)
{
    pel_place_set(p, pixel, BITS);
}

#include "body.inc"

static void fill(const struct pel_spans *spans, uint32_t pixel)
{
    const struct pel_span *span = spans->span;
    int32_t y = spans->y;
    for (int i = 0; i < spans->n; i++, span++, y += spans->step) {
        place p = at(spans->surface, span->x0, y);
        for (int32_t n = span->x1 - span->x0; n > 0; n--, p = next(p))
            set(p, pixel);
    }
}

static const struct pel_dithering dithering = {pattern, {1, 0, 0}};

const struct pel_format pel_mono1_pages = {
    .id = PEL_FORMAT_MONO1_PAGES,
    .bits = 1,
    .word = 1,
    .pack = pack,
    .unpack = unpack,
    .fill = fill,
    .blend = pel_blend_mono,
    .put = put,
    .load = load,
    .dithering = &dithering,
};
