/* Straight lines of any width. */
#ifndef PEL_RASTER_THICK_LINE_H
#define PEL_RASTER_THICK_LINE_H

#include "paint.h"

PEL_BEGIN_DECLS

struct pel_thick_line_shape {
    struct pel_point from, to;
    int32_t width; /* 1/256 px, 0..32,767 px */
};

/* The four corners: from + n, to + n, to - n, from - n, where n is the vector
 * (-(to.y - from.y), to.x - from.x) * width / (2 length), rounded to the
 * nearest sub-pixel (away from 0 at a tie; the length is floored to 31 binary
 * digits). So each corner is within one sub-pixel of its exact place, and the
 * ends swapped give the same four corners. All four lie on the line when it has
 * no length or no width. false when the line or one of its corners is out of
 * range. */
bool pel_thick_line_corners(const struct pel_thick_line_shape *line,
                            struct pel_point v[4]);

/* Fills the polygon of these corners, by the rule of raster/edge.h: the ends
 * are cut straight, across the line. A line out of range is a broken contract:
 * PEL_ASSERT, and nothing is drawn. */
void pel_thick_line(const struct pel_surface *surface,
                    const struct pel_thick_line_shape *line,
                    const struct pel_paint *paint);
PEL_END_DECLS
#endif
