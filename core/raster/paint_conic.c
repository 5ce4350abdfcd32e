#include "paint_conic.h"

static void run(const void *paint, const struct pel_ramp_walk *walk, int32_t n,
                pel_color *colors)
{
    pel_ramp_run(&((const struct pel_conic *)paint)->ramp, walk, n, colors);
}

enum pel_status pel_conic_init(struct pel_conic *paint, struct pel_point center,
                               uint16_t start, const struct pel_ramp *ramp)
{
    enum pel_status status = pel_ramp_check(ramp);
    if (!paint)
        return PEL_ERROR_NULL;
    if (status != PEL_OK)
        return status;
    if (!pel_points_legal(&center, 1))
        return PEL_ERROR_RANGE;
    pel_color_paint_init(&paint->base, pel_conic_colors, pel_ramp_opaque(ramp));
    paint->ramp = *ramp;
    if (ramp->spread == PEL_PAD)
        paint->ramp.spread = PEL_REPEAT;
    paint->center = center;
    paint->start = (uint32_t)start << 16;
    paint->run = run;
    return PEL_OK;
}
