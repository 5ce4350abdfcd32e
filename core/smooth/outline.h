/* Outlines of parts of circles and of lines, which all round shapes are made
 * of. An outline goes clockwise on screen: the shape lies right of the sides
 * that it goes up, and left of those that it goes down. What lies between them
 * in a pixel is a sum over the sides that cross its row. */
#ifndef PEL_SMOOTH_OUTLINE_H
#define PEL_SMOOTH_OUTLINE_H

#include "smooth.h"
#include "strip.h"

/* A circle, or a part of one. */
struct pel_smooth_curve {
    struct pel_point center;
    struct pel_point spread; /* of a rounded rectangle's corners, 1/256 px */
    struct pel_smooth_circle circle;
#if !PEL_SMOOTH_TINY
    int32_t at[2]; /* where the circle is at the ends of the outline's row */
#endif
};

struct pel_smooth_place {
    int32_t x, y; /* 2^-16 px from a centre */
};

/* What an outline has in a row: a strip, in the picture that is mirrored if
 * `left`. */
struct pel_smooth_crossing {
    struct pel_smooth_strip strip;
    int32_t center;
    bool left, rising;
    bool below;   /* of a circle: of its lower half */
    int8_t other; /* the number of a side that is none of a circle's; or -1 */
};

/* A side that is upright, from one height to another in 2^-16 px, which has the
 * rest; false: none of it is in the row. */
bool pel_smooth_upright(struct pel_smooth_crossing *crossing, int32_t y,
                        int64_t from, int64_t to);

/* The inner boundary of a column that it crosses, in its picture. */
static inline int32_t pel_smooth_boundary(const struct pel_smooth_crossing *c,
                                          int32_t x)
{
    return (x * 256 - c->center) * 256;
}

/* The columns that it crosses. */
static inline struct pel_span pel_smooth_crossing_columns(
    const struct pel_smooth_crossing *c)
{
    const struct pel_span right = pel_smooth_crossed(&c->strip, c->center);
    const struct pel_span left = {-right.x1, -right.x0};
    return c->left ? left : right;
}

/* Adds what lies right of a crossing in the columns of a row from x0 to x1,
 * some of those that it crosses, and behind them, to what each has more than
 * the one before it; *sum is that of column x1. Its height is below 0 if it
 * falls. */
static PEL_ALWAYS_INLINE void pel_smooth_add_columns(
    const struct pel_smooth_crossing *c, struct pel_span columns,
    int32_t height, int32_t *sum)
{
    struct pel_smooth_arc_piece piece = {0, 0, INT32_MIN, 0};
    int32_t n = columns.x1 - columns.x0;
    int32_t u = pel_smooth_boundary(c, c->left ? -columns.x1 : columns.x0);
    *sum += height;
    sum -= c->left ? 1 : n;
    for (; n > 0;
         n--, u = (int32_t)((uint32_t)u + 65536), sum += c->left ? -1 : 1) {
        int32_t area = (int32_t)pel_smooth_column_area(&c->strip, u, &piece);
        if (!c->rising)
            area = -area;
        if (!c->left)
            area = height - area;
        sum[0] += area;
        sum[1] -= area;
    }
}

/* The coverage of a sum: where ends meet it may be more than a pixel. */
static inline uint8_t pel_smooth_sum_coverage(int32_t sum)
{
    return pel_smooth_coverage((uint32_t)pel_min(sum, 32768));
}

/* Is it of a full pixel, or of one that is empty? */
static inline bool pel_smooth_is_whole(uint8_t coverage)
{
    return (uint8_t)(coverage + 1) < 2;
}

/* Cuts a strip off below or above a place. */
static inline void pel_smooth_cut_at(struct pel_smooth_strip *s,
                                     const struct pel_smooth_place *p,
                                     bool below)
{
    const int32_t v = pel_magnitude(p->y), u = pel_magnitude(p->x);
    if (below && v > s->near) {
        s->near = v;
        s->at_near = u;
    }
    if (!below && v < s->far) {
        s->far = v;
        s->at_far = u;
    }
}

/* Ends what has been cut: false: nothing is left. */
static inline bool pel_smooth_is_left(struct pel_smooth_strip *s)
{
    s->at_far = pel_min(s->at_far, s->at_near);
    return s->near < s->far;
}

#if !PEL_SMOOTH_TINY
struct pel_smooth_outline;

/* What the sides of an outline are, beside whole circles. */
struct pel_smooth_sides {
    /* Cuts a strip of the kth quarter of the ith curve, which begins at the
     * upright axis or at the level one, at the curve's ends; false: none is
     * left. NULL: curves have no ends. */
    bool (*cut)(const struct pel_smooth_outline *outline, int32_t i, int32_t k,
                bool upright, struct pel_smooth_strip *strip);
    /* The ith other side in row y; false: there is none. */
    bool (*other)(struct pel_smooth_outline *outline, int32_t y, int32_t i,
                  struct pel_smooth_crossing *crossing);
    /* Moves it on from the row above: it crosses both as a whole. NULL: none
     * does so, or all are found anew in each row (pel_smooth_find_end). */
    void (*down)(struct pel_smooth_outline *outline, int32_t i,
                 struct pel_smooth_crossing *crossing);
};

struct pel_smooth_outline {
    struct pel_smooth smooth; /* first */
    struct pel_rect seen;     /* px */
    struct pel_smooth_curve *curve;
    const struct pel_smooth_sides *sides; /* NULL: circles alone */
    int32_t row;                          /* that curves were at last */
    uint8_t curves, count;                /* of sides that are no curves */
    bool inside;                          /* no column is clipped away */
    bool mirrored;       /* rows are painted with their mirror images now, .. */
    int32_t mirror_from; /* .. which they have from here on, .. */
    int32_t mirror_y;    /* .. and to which their y adds up */
    int32_t alike; /* down to here no side begins or ends (whole_rows.c) */
};

/* Begins to paint an outline that has all but seen, row, inside, mirrored,
 * mirror_y and alike, which are set here. From row mirror_from down to the
 * centre of its first curve, or of the corners of a rectangle, rows have mirror
 * images below it. False: nothing in the box of pixels can be seen. */
bool pel_smooth_outline_begin(struct pel_smooth_outline *outline,
                              const struct pel_rect *box);

/* Paints what is to be seen. */
void pel_smooth_outline_paint(struct pel_smooth_outline *outline);

/* Finds the crossings of row y, of which it puts some into an array, from one
 * on: how many there are. */
int32_t pel_smooth_find_crossings(struct pel_smooth_outline *outline, int32_t y,
                                  int32_t first, int32_t most,
                                  struct pel_smooth_crossing *to);

/* The first height, from the top of row y on, at which a side may begin or end.
 */
int32_t pel_smooth_find_end(const struct pel_smooth_outline *outline,
                            int32_t y);

/* Paints some rows from y on, above `end`, in which 2 or 4 sides cross whole
 * rows apart from each other, and their mirror images: how many. */
int32_t pel_smooth_whole_rows(struct pel_smooth_outline *outline, int32_t y,
                              int32_t end);
#endif

#endif
