#include "ramp_vector.h"

#if PEL_FAST_64BIT

void pel_ramp_prepare(struct pel_ramp_mixer *mixer, const struct pel_ramp *ramp)
{
    mixer->ramp = ramp;
    mixer->run = NULL;
    mixer->padded = NULL;
#if PEL_VECTORS
    if (ramp->spread == PEL_REFLECT)
        return;
    if (ramp->n == 2)
        pel_ramp_prepare_mix(mixer);
    else
        pel_ramp_prepare_table(mixer);
#endif
}

#endif
