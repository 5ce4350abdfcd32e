/* Filled circles. */
#ifndef PEL_ROUND_CIRCLE_H
#define PEL_ROUND_CIRCLE_H

#include "../raster/paint.h"

PEL_BEGIN_DECLS

/* Fills the closed disc: the pixels whose centre (X, Y) satisfies
 * (X - center.x)^2 + (Y - center.y)^2 <= radius^2, all in sub-pixels, exactly.
 * The radius is 0 to 32,767 px. Around a pixel centre (PEL_PX(x) + 128) a whole
 * radius r gives a disc 2 r + 1 px wide, with one pixel alone at each of its
 * four ends; r + 1/4 px is as wide, without these. A disc of whole diameter d
 * in a d x d box has its centre at PEL_PX(x) + d * 128 and the radius d * 128,
 * and is d wide. Radius 0 covers a pixel when the centre is that pixel's. */
void pel_circle(const struct pel_surface *surface, struct pel_point center,
                int32_t radius, const struct pel_paint *paint);
PEL_END_DECLS
#endif
