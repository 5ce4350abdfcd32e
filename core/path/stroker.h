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
    uint32_t corner;    /* of the circle, the last one before n or in it */
    bool is_long;       /* surely not shorter than half of the width */
    bool seen;          /* near the rows; else nothing above is set */
};

struct pel_stroker {
    struct pel_pen pen;
    bool has_line, has_point; /* in this part of the path */
    const struct pel_stroke *stroke;
    int32_t half;  /* of the width, rounded down */
    int32_t reach; /* how far the border may be from a point */
    int32_t limit; /* of a miter, 256ths of half */
    int circle;    /* log2 of the sides of a round join's circle */
    int32_t round; /* the radius of their corners */
    struct pel_point start, at;
    struct pel_point p;         /* of the piece that is drawn */
    struct pel_point direction; /* of the line whose dashes are drawn: ends
                                   that are rounded would turn short ones; else
                                   0 */
    /* Of a turn: the lines beside which its outer side begins and ends, and 1
     * where that is on the left of the stroke, else -1. */
    const struct pel_stroke_line *from, *to;
    int32_t side;
    struct pel_stroke_line last, line, first; /* the one before, the present
                                                 one, and the first of this
                                                 part, which may be a dot's */
};

/* What a stroke goes along: walk lets a pen draw the lines of a shape. */
struct pel_lines {
    enum pel_status (*walk)(const void *shape, struct pel_pen *pen);
    const void *shape;
    const struct pel_stroke *stroke;
};

/* What makes the pen of a stroke with dashes at the head of the sides' memory.
 */
struct pel_dash_kind {
    enum pel_status (*begin)(const struct pel_stroke *stroke,
                             struct pel_sides *sides);
};

/* Makes the sides of a stroke, with dashes or without; the source, whose shape
 * is a struct pel_lines. */
enum pel_status pel_stroke_walk(const void *lines, struct pel_sides *sides);

/* Fills the stroke: the pixels whose centre is inside one of its pieces. */
enum pel_status pel_stroke_fill(const struct pel_surface *surface,
                                const struct pel_lines *lines,
                                const struct pel_paint *paint,
                                const struct pel_scratch *scratch);

/* Does that cover pixel (x, y)? */
bool pel_stroke_hit(const struct pel_lines *lines, int32_t x, int32_t y);

/* PEL_ERROR_RANGE: a number of the stroke is out of range. */
enum pel_status pel_stroker_begin(struct pel_stroker *s,
                                  const struct pel_stroke *stroke,
                                  struct pel_sides *sides);

/* What its pen draws. */
enum pel_status pel_stroker_draw(struct pel_pen *pen, enum pel_verb verb,
                                 const struct pel_point *p);

/* Is all that may be drawn at a point in range? */
static inline bool pel_stroker_takes(const struct pel_stroker *s,
                                     const struct pel_point *p)
{
    const int32_t most = s->pen.most;
    return p->x >= -most && p->x <= most && p->y >= -most && p->y <= most;
}

/* What stroke_turn.c draws: the border from the line that goes to s->at, the
 * last one, to the next; the two ends of a part; a dot that lies along the
 * first line. */
void pel_stroke_join(struct pel_stroker *s, const struct pel_stroke_line *next);
void pel_stroke_begin(struct pel_stroker *s);
void pel_stroke_end(struct pel_stroker *s);
void pel_stroke_dot(struct pel_stroker *s);

/* round(v a / b), away from 0 at a tie: |v| and a below 2^30, b above 0. */
int32_t pel_stroke_part(int32_t v, int32_t a, int32_t b);

/* Of the circle, of which the strokes that have it have lines. */
uint32_t pel_stroke_corner(struct pel_point direction, int circle);

/* Goes along a side to (x, y) from s->p, or to what is on the left of a line
 * there, on the right where side is -1; or moves there, where a side begins.
 * Then ends a rectangle, a wedge or a cap. */
static inline void pel_border_to(struct pel_stroker *s, int32_t x, int32_t y)
{
    s->pen.sides->kind->add(s->pen.sides, s->p.x + x, s->p.y + y);
}

void pel_border_beside(struct pel_stroker *s,
                       const struct pel_stroke_line *line, int32_t side);
void pel_border_move(struct pel_stroker *s, const struct pel_stroke_line *line,
                     int32_t side);

static inline void pel_border_end(struct pel_stroker *s)
{
    struct pel_sides *const sides = s->pen.sides;
    if (sides->kind->end)
        sides->kind->end(sides);
}

#endif
