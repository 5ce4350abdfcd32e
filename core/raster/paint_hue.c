#include "paint_hue.h"

#include "../base/hsv.h"

static void run(const void *paint, const struct pel_ramp_walk *walk, int32_t n,
                pel_color *colors)
{
    const struct pel_hue_wheel *p = paint;
    struct pel_ramp_walk w = *walk;
    for (; n > 0; n--, pel_ramp_step(&w))
        *colors++ = pel_hsv((int32_t)(w.at >> 48), p->s, p->v);
}

enum pel_status pel_hue_wheel_init(struct pel_hue_wheel *paint,
                                   struct pel_point center, uint16_t start,
                                   uint8_t s, uint8_t v)
{
    if (!paint)
        return PEL_ERROR_NULL;
    paint->s = s;
    paint->v = v;
    return pel_conic_begin(&paint->conic, center, start, run);
}
