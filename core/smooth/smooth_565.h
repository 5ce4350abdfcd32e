/* One color over pixels of 16 bits, in the three formats of 5-6-5 bits. */
#ifndef PEL_SMOOTH_SMOOTH_565_H
#define PEL_SMOOTH_SMOOTH_565_H

#include "smooth.h"

/* Pixels that have a coverage, in n rows: the first is row y, the next one
 * `step` below. In a row one run of them ends at an x, and another one begins
 * at the next x. */
struct pel_smooth_runs {
    int32_t y, step, n;
    const int32_t *x;
    const uint8_t *count, *coverage;
};

/* Where code is to be small (PEL_SMOOTH_TINY) these formats have no function of
 * their own. */
static inline bool pel_smooth_is_565(const struct pel_surface *surface)
{
    return !PEL_SMOOTH_TINY && surface->format &&
           surface->format->id <= PEL_FORMAT_BGR565_LE;
}

/* Mixes the color with the coverage for its alpha into them. */
void pel_smooth_mix_565(const struct pel_surface *surface,
                        const struct pel_smooth_runs *runs, pel_color color);
#endif
