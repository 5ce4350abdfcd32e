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

#endif
