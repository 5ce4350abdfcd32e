/* Smooth ellipses with axes along x and y. */
#ifndef PEL_SMOOTH_SMOOTH_ELLIPSE_H
#define PEL_SMOOTH_SMOOTH_ELLIPSE_H

#include "../round/ellipse.h"
#include "smooth.h"

PEL_BEGIN_DECLS

/* Paints the ellipse, each pixel by the area that it covers (smooth.h). Radii
 * are 0 to 32,767 px; one of 0 has no area and paints nothing. The coverage is
 * within 1.1 of 255 times the area up to radii of 2,048 px, and within .57 of
 * it where both are 16 px or more. Equal radii give the area of
 * pel_smooth_circle, which takes less time. */
void pel_smooth_ellipse(const struct pel_surface *surface,
                        const struct pel_ellipse_shape *shape,
                        const struct pel_paint *paint);
PEL_END_DECLS
#endif
