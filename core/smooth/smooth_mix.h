/* Colors mixed into pixels by the words of the commonest formats, in loops of
 * their own. Not where code is to be small (PEL_SMOOTH_TINY). */
#ifndef PEL_SMOOTH_SMOOTH_MIX_H
#define PEL_SMOOTH_SMOOTH_MIX_H

#include "smooth.h"

/* Pixels that have a coverage, in n rows: the first is row y, the next one
 * `step` below. Each row has two of x, count and, for each pixel, coverage: the
 * run that ends at the first x, and the run that begins at the second. */
struct pel_smooth_runs {
    int32_t y, step, n;
    const int32_t *x;
    const uint8_t *count, *coverage;
};

/* Is the surface of one of the three formats of 5-6-5 bits, or of the four with
 * 8-8-8 bits in words of 32? */
static inline bool pel_smooth_mixes(const struct pel_surface *surface)
{
    const uint8_t id = surface->format->id;
    return id <= PEL_FORMAT_BGR565_LE ||
           (id >= PEL_FORMAT_XRGB8888 && id <= PEL_FORMAT_BGRX8888);
}

/* Mixes one color into the runs of such a surface, its alpha times coverage. */
void pel_smooth_mix(const struct pel_surface *surface,
                    const struct pel_smooth_runs *runs, pel_color color);

/* Mixes n colors with a coverage each into pixels from an address on. */
typedef void pel_smooth_mixer(uintptr_t at, int32_t n, const pel_color *colors,
                              const uint8_t *coverage);

/* The one of rgb565_le, rgb565_be or xrgb8888; NULL for other formats. */
pel_smooth_mixer *pel_smooth_mixer_of(const struct pel_format *format);
#endif
