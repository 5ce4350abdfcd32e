/* One color over pixels of 16 bits, in the three formats of 5-6-5 bits, and of
 * 32 bits, in the four of 8-8-8. */
#ifndef PEL_SMOOTH_SMOOTH_MIX_H
#define PEL_SMOOTH_SMOOTH_MIX_H

#include "smooth.h"

/* Pixels that have a coverage, in n rows: the first is row y, the next one
 * `step` below. In a row one run of them ends at an x, and another one begins
 * at the next x. */
struct pel_smooth_runs {
    int32_t y, step, n;
    const int32_t *x;
    const uint8_t *count, *coverage;
};

/* Is the surface of one of these formats? */
static inline bool pel_smooth_mixes(const struct pel_surface *surface)
{
    const uint8_t id = surface->format->id;
    return id <= PEL_FORMAT_BGR565_LE ||
           (id >= PEL_FORMAT_XRGB8888 && id <= PEL_FORMAT_BGRX8888);
}

/* Mixes the color with the coverage for its alpha into them. Not where code is
 * to be small (PEL_SMOOTH_TINY). */
void pel_smooth_mix(const struct pel_surface *surface,
                    const struct pel_smooth_runs *runs, pel_color color);

/* Has it a way for pixels of a color each? */
static inline bool pel_smooth_mixes_colors(const struct pel_surface *surface)
{
    const uint8_t id = surface->format->id;
    return id <= PEL_FORMAT_RGB565_BE || id == PEL_FORMAT_XRGB8888;
}

/* Mixes the colors of a row's pixels into it. */
void pel_smooth_mix_row(const struct pel_surface *surface,
                        const struct pel_smooth_row *row,
                        const pel_color *colors);
#endif
