/* Filled ellipses with axes along x and y. */
#ifndef PEL_ROUND_ELLIPSE_H
#define PEL_ROUND_ELLIPSE_H

#include "../raster/paint.h"

PEL_BEGIN_DECLS

struct pel_ellipse_shape {
    struct pel_point center;
    struct pel_point radius; /* along x and along y, 0..32,767 px each */
};

/* Fills the closed ellipse: the pixels whose centre is at (u, v) from the
 * ellipse's with |u| <= radius.x, |v| <= radius.y and
 * u^2 radius.y^2 + v^2 radius.x^2 <= radius.x^2 radius.y^2, all in sub-pixels,
 * exactly, over the whole range. Equal radii give pel_circle; a radius of 0
 * leaves the pixels whose centre lies on the other axis. */
void pel_ellipse(const struct pel_surface *surface,
                 const struct pel_ellipse_shape *ellipse,
                 const struct pel_paint *paint);
PEL_END_DECLS
#endif
