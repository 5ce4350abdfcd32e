#include "paint_hue.h"

/* In each sixth of the turn one channel is v, one the lowest, and one between
 * them: where they lie. */
static const uint8_t between_shift[6] = {8, 16, 0, 8, 16, 0};
static const uint8_t v_shift[6] = {16, 8, 8, 0, 0, 16};

/* round(v (255 - s part / 512) / 255), part <= 512: floor(t / 512 / 255) with t
 * < 255 * 255 * 512 + 255 * 256, and floor(u / 255) = floor((u + 1 + floor(u /
 * 256)) / 256) for u < 65,535. */
static uint32_t level(const struct pel_hue_wheel *p, uint32_t part)
{
    uint32_t t = p->v * (255 * UINT32_C(512) - p->s * part) + 255 * 256;
    t >>= 9;
    return (t + 1 + (t >> 8)) >> 8;
}

static pel_color color(const struct pel_gradient *gradient, int32_t cell)
{
    const struct pel_hue_wheel *p = (const void *)gradient;
    const int32_t sixth = cell >> 8;
    const uint32_t part = (uint32_t)(cell & 255) * 2 + 1;
    const int between = between_shift[sixth], top = v_shift[sixth];
    return UINT32_C(0xFF000000) | (uint32_t)p->v << top |
           level(p, sixth & 1 ? part : 512 - part) << between |
           level(p, 512) << (24 - between - top);
}

enum pel_status pel_hue_wheel_init(struct pel_hue_wheel *paint,
                                   struct pel_point center, uint16_t start,
                                   uint8_t s, uint8_t v)
{
    if (!paint)
        return PEL_ERROR_NULL;
    pel_paint_clear(&paint->conic.base.paint);
    paint->s = s;
    paint->v = v;
    paint->conic.base.color = color;
    paint->conic.base.ramp.n = 0;
    paint->conic.base.cells = 6 * 256;
    paint->conic.base.period = 6 * 256;
    return pel_conic_begin(&paint->conic, center, start);
}
