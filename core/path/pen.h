/* The seam between a path, or what walks points, and what draws its lines: a
 * fill, a stroke, dashes before a stroke. */
#ifndef PEL_PATH_PEN_H
#define PEL_PATH_PEN_H

#include "sides.h"

/* A coordinate of a curve: the factors of t, t^2 and t^3. */
struct pel_factors {
    int32_t c, b, a;
};

/* Curves on their way to a pen. */
struct pel_curves {
    struct pel_pen *pen;
    int32_t tolerance;            /* as in struct pel_path_shape */
    struct pel_point start, v[4]; /* where the part began; where the curve does,
                                     and the points that its verb takes */
    struct pel_factors x, y;      /* of a curve of 2^k lines, */
    struct pel_point to;          /* at the end of number i */
    int32_t i;
    int k;
    bool seen, closed;
};

/* May a shape have it? 0 stands for the usual one. */
static inline bool pel_tolerance_legal(int32_t tolerance)
{
    return tolerance == 0 || (tolerance >= 4 && tolerance <= 65535);
}

/* A path that is walked. */
struct pel_path_state {
    const struct pel_path_shape *shape;
    const uint8_t *verb;
    int32_t next, points; /* the next point; how many there are */
    bool begun;
    struct pel_curves curves;
};

struct pel_pen {
    /* PEL_MOVE begins a part at *p, which is legal, and NULL ends the path;
     * PEL_LINE goes to *p; PEL_CLOSE ends a part where it began. */
    enum pel_status (*draw)(struct pel_pen *pen, enum pel_verb verb,
                            const struct pel_point *p);
    int32_t top, bottom; /* what lies on one side of these rows, in sub-pixels,
                            may be left out: a curve may become three lines, and
                            lines one */
    int32_t most;        /* of a coordinate of a legal point */
    struct pel_sides *sides;
    void *memory; /* for a struct pel_path_state */
};

/* Is what lies between two heights near the rows? */
static inline bool pel_pen_sees(const struct pel_pen *pen, int32_t a, int32_t b)
{
    return pel_max(a, b) >= pen->top && pel_min(a, b) <= pen->bottom;
}

/* Draws what the verb does with the points from v[1] on, which are legal. */
enum pel_status pel_curves_add(struct pel_curves *curves, enum pel_verb verb);

/* The pen of a fill, which makes sides of lines and closes parts. */
struct pel_fill_pen {
    struct pel_pen pen;
    struct pel_point start;
};

void pel_fill_pen_begin(struct pel_fill_pen *pen, struct pel_sides *sides);

#endif
