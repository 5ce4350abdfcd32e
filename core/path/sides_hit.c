/* Sides that pass the centre of a pixel. */
#include "../raster/crossing.h"
#include "sides.h"

struct hit {
    struct pel_sides sides;
    struct pel_point center;
    int32_t winding;
};

static bool add(struct pel_sides *sides, const struct pel_point *a,
                const struct pel_point *b)
{
    struct hit *const h = (struct hit *)(void *)sides;
    h->winding += pel_crossing(a, b, h->center);
    return true;
}

static const struct pel_sides_kind hit_kind = {.add = add};

bool pel_sides_hit(const struct pel_outline_source *source,
                   enum pel_fill_rule rule, int32_t x, int32_t y)
{
    struct hit h = {.sides.kind = &hit_kind};
    if ((((uint32_t)x + 32768u) | ((uint32_t)y + 32768u)) >> 16)
        return false;
    h.center = (struct pel_point){pel_pixel_center(x), pel_pixel_center(y)};
    h.sides.top = PEL_PX(y);
    h.sides.bottom = PEL_PX(y + 1);
    return source->walk(source->shape, &h.sides) == PEL_OK &&
           (rule == PEL_EVEN_ODD ? h.winding & 1 : h.winding != 0);
}
