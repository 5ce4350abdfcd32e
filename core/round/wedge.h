/* The walk over the part of every row that lies between two angles.
 *
 * The rule. From the centre C, angle a has the ray in the direction
 * d = pel_direction(a). A pixel's centre P belongs to the half-open range
 * [from, to), clockwise, when it lies on the ray of `from` or between the two:
 * for up to a half turn when
 *
 *     cross(d(from), P - C) > 0 and cross(d(to), P - C) < 0,
 *     or P lies on the ray of `from`;
 *
 * a larger range is what the rest of the turn leaves. cross((a, b), (x, y)) =
 * a y - b x. A pixel centre on C counts as angle 0. from == to is empty. So the
 * ranges [a, b), [b, c), [c, a) hold every pixel once. */
#ifndef PEL_ROUND_WEDGE_H
#define PEL_ROUND_WEDGE_H

#include "../raster/cut.h"
#include "../raster/edge.h"

/* A ray as the walk of an exact edge. Above the centre a row's angles grow with
 * x, below it they fall: there the edge is walked in a mirror, where pixel x is
 * pixel -1 - x. So a pixel on the ray itself always belongs to the range that
 * begins there. */
struct pel_ray {
    struct pel_edge edge; /* at the next row */
    int32_t bound; /* the edge's first row, or below the centre its end */
};

struct pel_angles {
    uint16_t from, to; /* turns / 65,536 */
};

struct pel_wedge {
    struct pel_angles angles;
    struct pel_ray from, to;
};

/* From line y on. false: nothing can be covered, since from == to. The centre
 * is legal. */
bool pel_wedge_start(struct pel_wedge *wedge, const struct pel_point *center,
                     struct pel_angles angles, int32_t y);

/* The parts of line y inside the wedge, from left to right and apart from each
 * other; one may be empty. They reach beyond every pixel. Every line is asked
 * for once, from the first one down. */
void pel_wedge_parts(struct pel_wedge *wedge, const struct pel_point *center,
                     int32_t y, struct pel_span part[2]);

#endif
