/* Filled arcs: sectors of rings. */
#ifndef PEL_ROUND_ARC_H
#define PEL_ROUND_ARC_H

#include "../raster/paint.h"

PEL_BEGIN_DECLS

struct pel_arc_shape {
    struct pel_point center;
    int32_t inner, outer; /* 1/256 px, 0..32,767 px */
    int32_t from, to;     /* turns / 65,536, clockwise on screen from +x */
};

/* Fills the pixels of pel_ring(center, inner, outer) whose centre lies between
 * the two angles, by the rule of pel_sector: a curved band, outer - inner wide.
 * Arcs tile: around the turn, and with the rings and discs inside and around
 * them. Nothing when outer <= inner or from and to are one angle; the whole
 * ring when to - from is 65,536 or more, as of a gauge at 100 %. */
void pel_arc(const struct pel_surface *surface, const struct pel_arc_shape *arc,
             const struct pel_paint *paint);
PEL_END_DECLS
#endif
