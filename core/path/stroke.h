/* What a stroke along a path looks like. */
#ifndef PEL_PATH_STROKE_H
#define PEL_PATH_STROKE_H

#include "../base/point.h"

PEL_BEGIN_DECLS

/* Its two ends: cut off, half of the width longer, or half a disc. */
enum pel_cap { PEL_CAP_BUTT, PEL_CAP_SQUARE, PEL_CAP_ROUND };

/* Where it turns: the corner cut off, both sides up to where they meet, or a
 * part of a disc. */
enum pel_join { PEL_JOIN_BEVEL, PEL_JOIN_MITER, PEL_JOIN_ROUND };

struct pel_dash_kind;

/* What links the code of dashes: programs that do not name it have none. */
extern const struct pel_dash_kind pel_dashed;

struct pel_dashes {
    const struct pel_dash_kind *kind; /* &pel_dashed */
    const int32_t *length; /* of a dash, a gap, a dash ..., 1/256 px, again and
                              again. Their sum, twice that if their number is
                              odd, is 1 to 32,767 px. */
    int32_t count;         /* 1 to 64 */
    int32_t phase;         /* how far in them a part of a path begins, 1/256 px:
                              0 to PEL_PX(32767) */
};

/* A stroke covers what lies within half of its width, rounded down to 1/256 px,
 * beside each line, and its joins and caps. It is exact but for this: corners
 * of the border are rounded to the nearest 1/256 px, which changes nothing
 * where lines are level or upright; round ones are polygons within 1/96 px and
 * 1/8,192 of the radius of the circle; a curve is its lines, within the
 * tolerance, and joins between those are as between others.
 *
 * A part of a path without length is a disc with round caps, an upright square
 * with square ones, else nothing; so is a polyline of one point, but a PEL_MOVE
 * alone is nothing. Each dash has caps, and joins where it turns; its ends are
 * rounded, too, not its direction. A dash without length is a disc or a square
 * along its line. Dashes of a closed part do not join where it begins. Each
 * dash of a line that is near the rows takes time, also of one that is level
 * and longer than the clip is wide. */
struct pel_stroke {
    int32_t width; /* across, in 1/256 px: 0 to PEL_PX(32767) */
    enum pel_cap cap;
    enum pel_join join;
    int32_t miter_limit; /* how far from a turn sides may meet, in 256ths of
                            half of the width, 256 to 4,096; 0 is 1,024. Beyond
                            that a corner is cut off. */
    const struct pel_dashes *dashes; /* NULL: none */
};
PEL_END_DECLS
#endif
