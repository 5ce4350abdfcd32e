#include "paint_hue.h"

/* pel_hsv() for a walk. In each sixth of the turn one channel is v, one the
 * lowest, and one between them: where they lie. */
static const uint8_t between_shift[6] = {8, 16, 0, 8, 16, 0};
static const uint8_t v_shift[6] = {16, 8, 8, 0, 0, 16};

/* round(v (255 - s part / 65,536) / 255), part <= 65,536: floor(t / 65,536 /
 * 255) with t < 255 * 255 * 65,536 + 255 * 32,768, and floor(u / 255) =
 * floor((u + 1 + floor(u / 256)) / 256) for u < 65,535. */
static uint32_t level(const struct pel_hue_wheel *p, uint32_t part)
{
    uint32_t t = p->v * (255 * UINT32_C(65536) - p->s * part) + 255 * 32768;
    t >>= 16;
    return (t + 1 + (t >> 8)) >> 8;
}

static void color_walk(const struct pel_hue_wheel *p, struct pel_ramp_walk *w,
                       int32_t n, pel_color *colors)
{
    const uint32_t v = p->v, lowest = level(p, 65536);
    for (; n > 0; n--, pel_ramp_step(w)) {
        uint32_t six = (uint32_t)(w->at >> 48) * 6, sixth = six >> 16;
        uint32_t part = six & 0xFFFFu;
        int between = between_shift[sixth], top = v_shift[sixth];
        part = level(p, sixth & 1 ? part : 65536 - part);
        *colors++ = UINT32_C(0xFF000000) | v << top | part << between |
                    lowest << (24 - between - top);
    }
}

#if PEL_FAST_64BIT

static void run(const void *curve, const struct pel_ramp_walk *walk,
                pel_color *colors)
{
    const struct pel_conic *conic = PEL_CURVE_PAINT(struct pel_conic, curve);
    struct pel_ramp_walk w = *walk;
    color_walk((const void *)conic, &w, w.n, colors);
}

#else

static void run(const struct pel_curve *curve, struct pel_ramp_walk *w,
                int32_t n, pel_color *colors)
{
    const struct pel_conic *conic = PEL_CURVE_PAINT(struct pel_conic, curve);
    color_walk((const void *)conic, w, n, colors);
}

#endif

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
