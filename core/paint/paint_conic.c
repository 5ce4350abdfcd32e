#include "paint_conic.h"

enum pel_status pel_conic_init(struct pel_conic *paint, struct pel_point center,
                               uint16_t start, const struct pel_ramp *ramp)
{
    const enum pel_status status = pel_gradient_init((void *)paint, ramp);
    if (status != PEL_OK)
        return status;
    return pel_conic_begin(paint, center, start);
}
