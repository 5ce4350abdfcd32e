/* Straight sides of outlines. */
#ifndef PEL_SMOOTH_LINE_SIDE_H
#define PEL_SMOOTH_LINE_SIDE_H

#include "outline.h"

/* A place in 2^-16 px. */
struct pel_smooth_far_place {
    int64_t x, y;
};

/* Sets what lies between two places at the top and the bottom of a part of a
 * row, all but its heights, its slope and whether it is rising: the first place
 * on the left, and the way from the upper to the lower one. Half of the longest
 * line ends up to a sub-pixel early, as it would be beyond the range. */
static inline void pel_smooth_line_cross(struct pel_smooth_crossing *c,
                                         int64_t first, int32_t way)
{
    c->center = (int32_t)(first >> 8);
    c->strip.at_far = first & 255;
    c->strip.at_near =
        pel_min(pel_magnitude(way), INT32_MAX - 255) + c->strip.at_far;
    c->left = false;
}

#if PEL_SMOOTH_TINY
/* x at the top or the bottom of row y of a line down, which moves so far to the
 * next row, px 2^-32; or where it begins or ends in the row. */
int64_t pel_smooth_line_at(const struct pel_smooth_far_place end[2],
                           const int64_t *step, int32_t y, bool bottom);
#else
/* Where a part of a circle begins and ends, clockwise. */
struct pel_smooth_ends {
    struct pel_smooth_place from, to;
};

/* Where curve k of an outline ends, and where the next one begins; or, flipped,
 * the other way around. */
void pel_smooth_joint(const struct pel_smooth_outline *outline, int32_t k,
                      bool flipped, struct pel_smooth_far_place place[2]);

/* A line down, from the end of a curve to where the next one begins or, if the
 * outline goes up, the other way around. */
struct pel_smooth_line {
    int64_t at, step; /* at the top of a row, to the next: px 2^-32 */
    int32_t row;
    int32_t first, end; /* rows that it crosses as a whole */
    struct pel_smooth_slope slope;
    uint8_t curve;
    bool rising; /* the outline goes up */
};

/* Cuts quarters of curves (of struct pel_smooth_sides). */
bool pel_smooth_cut(const struct pel_smooth_outline *outline, int32_t i,
                    int32_t k, bool upright, struct pel_smooth_strip *strip);

/* An outline of two curves and the lines between them. */
struct pel_smooth_lines {
    struct pel_smooth_outline outline; /* first */
    struct pel_smooth_ends *ends;      /* of each curve */
    struct pel_smooth_line *line;
    bool wide; /* a row may hold more than the range of a strip */
};

static inline struct pel_smooth_ends *pel_smooth_ends_of(
    const struct pel_smooth_outline *outline, int32_t i)
{
    return ((const struct pel_smooth_lines *)(const void *)outline)->ends + i;
}

/* Begins it with two curves, which the caller sets, and no line yet. */
void pel_smooth_lines_begin(struct pel_smooth_lines *lines,
                            struct pel_smooth_curve *curve,
                            struct pel_smooth_ends *ends,
                            struct pel_smooth_line *line, bool wide);

/* Adds a line from curve k to the next one, in a direction, or that of the one
 * before if it is NULL; none if it is level. */
void pel_smooth_lines_add(struct pel_smooth_lines *lines,
                          const struct pel_point *direction, int32_t k);

#endif
#endif
