/* Spans of the pixels between two angles, row by row.
 *
 * The rule. The ray of angle a begins at the centre C and has the direction
 * d(a) = pel_direction(a). A pixel with the centre P belongs to the half-open
 * range [from, to), clockwise, of up to half a turn, when
 *
 *     cross(d(from), P - C) > 0 and cross(d(to), P - C) < 0,
 *     or P lies on the ray of `from`;
 *
 * a larger range holds the pixels that [to, from) does not. cross((a, b),
 * (x, y)) = a y - b x. A pixel centre on C counts as angle 0. So the
 * ranges [a, b), [b, c), [c, a) hold every pixel once. */
#ifndef PEL_ROUND_ANGLE_RANGE_H
#define PEL_ROUND_ANGLE_RANGE_H

#include "../raster/cut.h"
#include "../raster/edge.h"
#include "arc.h"

/* A ray, walked as an exact edge (raster/edge.h). Above the centre the angles
 * of a row grow with x, below it they fall. There the edge is mirrored, pixel x
 * to pixel -1 - x: so a pixel on a ray always belongs to the range that begins
 * at this ray. */
struct pel_ray {
    struct pel_edge edge; /* at the next row; before, x and m are those of the
                             direction, which takes no stack of its own */
    int32_t bound;        /* first row of the edge; below the centre its end */
};

struct pel_angles {
    uint16_t from, to; /* turns / 65,536; 0, 0 is a full turn */
};

/* The range from one angle to another, in any turns: a full one when `to` is at
 * least 65,536 larger. false: nothing, since the two are the same angle. */
static inline bool pel_angles_set(struct pel_angles *a, int32_t from,
                                  int32_t to)
{
    const bool full = to > from && (uint32_t)to - (uint32_t)from >= 65536;
    a->from = (uint16_t)(full ? 0 : from);
    a->to = (uint16_t)(full ? 0 : to);
    return full || a->from != a->to;
}

struct pel_angle_range {
    struct pel_angles angles;
    struct pel_ray from, to;
};

/* Cuts `visible` to a box around the arc, larger by `edge` px on every side,
 * and starts at the row so far above what is left, or at y if that is below.
 * The arc is legal. false: nothing is left, or covered (pel_angles_set). */
bool pel_angle_range_start(struct pel_angle_range *range,
                           const struct pel_arc_shape *arc,
                           struct pel_rect *visible, int32_t edge, int32_t y);

/* Sets two spans, disjoint and from left to right, to the part of row y inside
 * the range. They may be empty; open ends lie beyond every pixel. For every row
 * once, from the first one down. */
void pel_angle_range_spans(struct pel_angle_range *range,
                           const struct pel_point *center, int32_t y,
                           struct pel_span span[2]);

#endif
