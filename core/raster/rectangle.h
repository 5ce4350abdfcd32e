/* Filled rectangles. */
#ifndef PEL_RASTER_RECTANGLE_H
#define PEL_RASTER_RECTANGLE_H

#include "paint.h"

PEL_BEGIN_DECLS

/* Fills the box of whole pixels. Any box will do; an empty one is nothing. */
void pel_box(const struct pel_surface *surface, const struct pel_rect *box,
             const struct pel_paint *paint);

/* The same by sub-pixels: the pixels whose centre lies in [from.x, to.x) x
 * [from.y, to.y), as a polygon has them. Nothing when to.x <= from.x or to.y <=
 * from.y. */
void pel_rectangle(const struct pel_surface *surface, struct pel_point from,
                   struct pel_point to, const struct pel_paint *paint);

/* Sets every pixel inside the clip to `color`, alpha ignored. */
void pel_clear(const struct pel_surface *surface, pel_color color);
PEL_END_DECLS
#endif
