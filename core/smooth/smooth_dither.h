/* The dither of colors before they are weighed, in the buffer of smooth.h: its
 * fill and put of struct pel_channels (base/format.h). */
#ifndef PEL_SMOOTH_SMOOTH_DITHER_H
#define PEL_SMOOTH_SMOOTH_DITHER_H

#include "smooth.h"

void pel_smooth_dither_fill(const struct pel_surface *surface,
                            const struct pel_spans *spans, pel_color color,
                            const pel_thresholds *rows);
int32_t pel_smooth_dither_put(const struct pel_surface *surface,
                              const struct pel_spans *spans,
                              const pel_color *colors,
                              const pel_thresholds *rows);
#endif
