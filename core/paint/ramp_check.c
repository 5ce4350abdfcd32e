#include "color_ramp.h"

enum pel_status pel_ramp_check(const struct pel_ramp *ramp)
{
    if (!ramp || !ramp->colors)
        return PEL_ERROR_NULL;
    return ramp->n < 1 || ramp->n > 32767 ? PEL_ERROR_SIZE : PEL_OK;
}
