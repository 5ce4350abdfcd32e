/* Smooth circles. */
#ifndef PEL_SMOOTH_SMOOTH_CIRCLE_H
#define PEL_SMOOTH_SMOOTH_CIRCLE_H

#include "smooth.h"

PEL_BEGIN_DECLS

/* Paints the disc around `center`, each pixel by the area that it covers
 * (smooth.h). The radius is 0 to 32,767 px; 0 has no area and paints nothing.
 * The coverage is within 1.1 of 255 times the area up to a radius of 2,048 px,
 * and within .57 of it from 16 px on. Where twice the centre's coordinates are
 * whole pixels and the disc is inside the clip it takes half the time, but for
 * builds with -Os. */
void pel_smooth_circle(const struct pel_surface *surface,
                       struct pel_point center, int32_t radius,
                       const struct pel_paint *paint);
PEL_END_DECLS
#endif
