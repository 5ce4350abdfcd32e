#include "color_ramp.h"

enum pel_status pel_ramp_check(const struct pel_ramp *ramp)
{
    if (!ramp || !ramp->colors)
        return PEL_ERROR_NULL;
    return ramp->n < 1 || ramp->n > 32767 ? PEL_ERROR_SIZE : PEL_OK;
}

bool pel_ramp_opaque(const struct pel_ramp *ramp)
{
    pel_color all = UINT32_C(0xFF000000);
    for (int32_t i = 0; i < ramp->n; i++)
        all &= ramp->colors[i];
    return pel_alpha(all) == 255;
}
