#include "paint_conic.h"

#include "patch.h"
#include "ramp_vector.h"

#if PEL_FAST_64BIT

static void mixed(const struct pel_color_paint *paint, int32_t x, int32_t y,
                  int32_t n, pel_color *out)
{
    const struct pel_conic *p = (const void *)paint;
    const struct pel_run run = {x, y, n};
    struct pel_ramp_mixer mixer;
    pel_ramp_prepare(&mixer, &p->ramp);
    pel_conic_colors(paint, &mixer, &run, out);
}

#if PEL_PATCHES

static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    const struct pel_conic *p = (const void *)paint;
    const struct pel_patchwork work = {&p->base,         &p->curve,
                                       &p->ramp,         pel_conic_taylor,
                                       pel_conic_colors, false};
    pel_patch_fill(&work, spans);
}

#endif

static void run(const void *mixer, const struct pel_ramp_walk *walk,
                pel_color *colors)
{
    pel_ramp_run(mixer, walk, colors);
}

static void set_colors(struct pel_conic *paint)
{
    paint->base.colors = mixed;
#if PEL_PATCHES
    paint->base.paint.fill = fill;
#endif
}

#else

static void run(const struct pel_curve *curve, struct pel_ramp_walk *walk,
                int32_t n, pel_color *colors)
{
    pel_ramp_run(&PEL_CURVE_PAINT(struct pel_conic, curve)->ramp, walk, n,
                 colors);
}

static void set_colors(struct pel_conic *paint)
{
    (void)paint;
}

#endif

/* Angles wrap, so a padded ramp is a repeated one. There and back is two ways
 * in a turn. */
enum pel_status pel_conic_init(struct pel_conic *paint, struct pel_point center,
                               uint16_t start, const struct pel_ramp *ramp)
{
    enum pel_status status = pel_ramp_check(ramp);
    if (status == PEL_OK)
        status = pel_conic_begin(paint, center, start, run);
    if (status != PEL_OK)
        return status;
    paint->base.opaque = pel_ramp_opaque(ramp);
    paint->ramp = *ramp;
    if (ramp->spread == PEL_PAD)
        paint->ramp.spread = PEL_REPEAT;
    if (ramp->spread == PEL_REFLECT)
        paint->curve.bits = 63;
    set_colors(paint);
    return PEL_OK;
}
