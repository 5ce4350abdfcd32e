#include "paint_hue.h"

/* pel_hsv() for a walk, with what s and v alone decide taken out of the loop.
 * In each sixth of the turn one channel is v, one p, and one between them. */
struct wheel {
    pel_color ends[6]; /* v and p in their places */
    uint32_t s, v;
};

/* Where the channel between lies. */
static const uint8_t between_shift[6] = {8, 16, 0, 8, 16, 0};
static const uint8_t v_shift[6] = {16, 8, 8, 0, 0, 16};

/* round(v (255 - s part / 65,536) / 255), part <= 65,536: floor(t / 65,536 /
 * 255) with t < 255 * 255 * 65,536 + 255 * 32,768, and floor(u / 255) =
 * floor((u + 1 + floor(u / 256)) / 256) for u < 65,535. */
static uint32_t level(const struct wheel *w, uint32_t part)
{
    uint32_t t = w->v * (255 * UINT32_C(65536) - w->s * part) + 255 * 32768;
    t >>= 16;
    return (t + 1 + (t >> 8)) >> 8;
}

static void set_wheel(struct wheel *w, uint32_t s, uint32_t v)
{
    w->s = s;
    w->v = v;
    const uint32_t p = level(w, 65536);
    for (int i = 0; i < 6; i++) {
        int p_shift = 24 - between_shift[i] - v_shift[i];
        w->ends[i] = UINT32_C(0xFF000000) | v << v_shift[i] | p << p_shift;
    }
}

static void run(const void *paint, const struct pel_ramp_walk *walk, int32_t n,
                pel_color *colors)
{
    const struct pel_hue_wheel *p = paint;
    struct pel_ramp_walk w = *walk;
    struct wheel wheel;
    set_wheel(&wheel, p->s, p->v);
    for (; n > 0; n--, pel_ramp_step(&w)) {
        uint32_t six = (uint32_t)(w.at >> 48) * 6, sixth = six >> 16;
        uint32_t part = six & 0xFFFFu;
        part = sixth & 1 ? part : 65536 - part;
        *colors++ = wheel.ends[sixth] | level(&wheel, part)
                                            << between_shift[sixth];
    }
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
