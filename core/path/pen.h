/* The seam between a path, or what walks points, and what draws its lines: a
 * fill, a stroke, dashes before a stroke. */
#ifndef PEL_PATH_PEN_H
#define PEL_PATH_PEN_H

#include "sides.h"

struct pel_pen {
    /* PEL_MOVE begins a part at *p, which is legal, and NULL ends the path;
     * PEL_LINE goes to *p; PEL_CLOSE ends a part where it began. */
    enum pel_status (*draw)(struct pel_pen *pen, enum pel_verb verb,
                            const struct pel_point *p);
    int32_t top, bottom; /* a curve outside of these rows, in sub-pixels, may
                            become three lines */
};

/* Walks a path whose lines a pen draws. */
enum pel_status pel_path_walk(const struct pel_path_shape *shape,
                              struct pel_pen *pen);

/* Curves on their way to a pen. */
struct pel_curves {
    struct pel_pen *pen;
    int32_t tolerance;            /* as in struct pel_path_shape */
    struct pel_point start, v[4]; /* where the part began; where the curve does,
                                     and the points that its verb takes */
    bool closed;
};

/* Draws what the verb does with the points from v[1] on, which are legal. */
enum pel_status pel_curves_add(struct pel_curves *curves, enum pel_verb verb);

/* Where a point lies; false: out of range. */
bool pel_transform_point(const struct pel_transform *transform, int32_t x,
                         int32_t y, struct pel_point *to);

/* The pen of a fill, which makes sides of lines and closes parts. */
struct pel_fill_pen {
    struct pel_pen pen;
    struct pel_sides *sides;
    struct pel_point start, at;
};

void pel_fill_pen_begin(struct pel_fill_pen *pen, struct pel_sides *sides);

#endif
