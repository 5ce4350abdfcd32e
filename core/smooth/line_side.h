/* Straight sides of outlines. */
#ifndef PEL_SMOOTH_LINE_SIDE_H
#define PEL_SMOOTH_LINE_SIDE_H

#include "outline.h"

/* A place in 2^-16 px. */
struct pel_smooth_far_place {
    int64_t x, y;
};

static inline struct pel_smooth_far_place pel_smooth_far_place_at(
    struct pel_point center, struct pel_smooth_place place)
{
    const struct pel_smooth_far_place far = {
        PEL_CAST(int64_t, center.x) * 256 + place.x,
        PEL_CAST(int64_t, center.y) * 256 + place.y};
    return far;
}

/* A line down. */
struct pel_smooth_line {
    struct pel_smooth_far_place top, bottom;
    int64_t at, step; /* at the top of a row, to the next: px 2^-32 */
    int32_t row;
    struct pel_smooth_slope slope;
    bool rising; /* the outline goes up */
};

/* Cuts quarters of bows (`cut` of an outline). */
bool pel_smooth_cut(struct pel_smooth_strip *strip,
                    const struct pel_smooth_bow *bow, int32_t k, bool upright);

/* An outline with two of them. */
struct pel_smooth_lines {
    struct pel_smooth_outline outline; /* first */
    struct pel_smooth_line *line;
    bool wide; /* a row may hold more than the range of a strip */
};

/* Adds a line in a direction, between two heights; none if it is level. */
void pel_smooth_lines_add(struct pel_smooth_lines *lines,
                          struct pel_point direction,
                          struct pel_smooth_far_place from,
                          struct pel_smooth_far_place to);

#endif
