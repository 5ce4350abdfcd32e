/* Filled sectors of discs. */
#ifndef PEL_ROUND_SECTOR_H
#define PEL_ROUND_SECTOR_H

#include "../raster/paint.h"

PEL_BEGIN_DECLS

struct pel_sector_shape {
    struct pel_point center;
    int32_t radius;   /* 1/256 px, 0..32,767 px */
    int32_t from, to; /* turns / 65,536, clockwise on screen from +x: any,
                         -1 is the angle 65,535 */
};

/* Fills the pixels of pel_circle(center, radius) whose centre lies between the
 * two angles, half-open: on the ray of `from` or clockwise of it, and before
 * the ray of `to`. Exact, by the integer directions pel_direction(from) and
 * pel_direction(to) (rule: round/angle_range.h): [a, b) and [b, c) share no
 * pixel and leave none between them, and sectors around the whole turn hold
 * every pixel of the disc once. A pixel centre on that of the disc counts as
 * angle 0. Nothing when from and to are one angle; the whole disc when to -
 * from is 65,536 or more. */
void pel_sector(const struct pel_surface *surface,
                const struct pel_sector_shape *sector,
                const struct pel_paint *paint);
PEL_END_DECLS
#endif
