/* The pen that makes the sides of a stroke. Each line of it is a rectangle, and
 * each turn a wedge on the outer side; all are drawn in one direction, so that
 * inside of any the winding number is not 0. Sides that two of them share, in
 * opposite directions, are left out. */
#ifndef PEL_PATH_STROKER_H
#define PEL_PATH_STROKER_H

#include "pen.h"

/* A line of the stroke. */
struct pel_stroke_line {
    struct pel_point n; /* half of the width across it, to the left */
    struct pel_point u; /* its direction, 2^29 long */
    bool is_long;       /* not shorter than half of the width */
    bool seen;          /* near the rows; else nothing above is set */
};

struct pel_stroker {
    struct pel_pen pen;
    struct pel_sides *sides;
    const struct pel_stroke *stroke;
    int32_t half;  /* of the width, rounded down */
    int32_t reach; /* how far the border may be from a point */
    int32_t limit; /* of a miter, 256ths of half */
    int circle;    /* log2 of the sides of a round join's circle */
    int32_t round; /* the radius of their corners */
    struct pel_point start, at;
    struct pel_point direction; /* of the line whose dashes are drawn: ends
                                   that are rounded would turn short ones; else
                                   0 */
    struct pel_stroke_line first, last; /* of this part of the path; first may
                                           be that of a dot */
    bool has_line, has_point;           /* in this part */
    bool room;
    struct pel_point border; /* where the border that is drawn has come to */
};

/* PEL_ERROR_RANGE: a number of the stroke is out of range. */
enum pel_status pel_stroker_begin(struct pel_stroker *s,
                                  const struct pel_stroke *stroke,
                                  struct pel_sides *sides);

/* Is all that may be drawn at a point in range? */
static inline bool pel_stroker_takes(const struct pel_stroker *s,
                                     const struct pel_point *p)
{
    const int32_t most = PEL_COORDINATE_MAX - s->reach;
    return p->x >= -most && p->x <= most && p->y >= -most && p->y <= most;
}

/* What stroke_turn.c draws at a point: the border from one line to the next; an
 * end, whose line goes there, or came from there: backwards; a dot that
 * lies along a line. */
void pel_stroke_join(struct pel_stroker *s, struct pel_point p,
                     const struct pel_stroke_line *before,
                     const struct pel_stroke_line *after);
void pel_stroke_cap(struct pel_stroker *s, struct pel_point p,
                    const struct pel_stroke_line *line, bool backwards);
void pel_stroke_dot(struct pel_stroker *s, struct pel_point p,
                    const struct pel_stroke_line *line);

/* Adds a side from a to b. */
static inline void pel_stroke_side(struct pel_stroker *s, struct pel_point a,
                                   struct pel_point b)
{
    s->room = s->room && s->sides->kind->add(s->sides, &a, &b);
}

#endif
