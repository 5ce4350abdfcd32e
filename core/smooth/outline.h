/* Outlines of parts of circles and of lines, in windows of rows. */
#ifndef PEL_SMOOTH_OUTLINE_H
#define PEL_SMOOTH_OUTLINE_H

#include "window.h"

struct pel_smooth_place {
    int32_t x, y; /* 2^-16 px from a centre */
};

/* Part of a circle, clockwise on screen from one place to another through some
 * quadrants, of which 0 begins at +x. */
struct pel_smooth_bow {
    struct pel_point center;
    struct pel_smooth_place from, to;
    uint8_t first, count; /* quadrants */
    bool hole;            /* the outline goes backwards */
    struct pel_smooth_circle circle;
    int32_t row;   /* of what follows */
    int32_t at[2]; /* where the circle is at its ends */
};

/* Sets the rest of a bow, of which the first six members are set. */
void pel_smooth_bow_set(struct pel_smooth_bow *bow, int32_t radius);

/* Part of a line from one height to another, around a base. */
struct pel_smooth_line {
    struct pel_point base;
    struct pel_smooth_place top, bottom;
    int64_t step; /* px 2^-32 to the next row */
    struct pel_rise rise;
    bool left; /* the shape is right of it */
};

/* A line down from one place to another, 2^-16 px from a base. */
struct pel_smooth_gap {
    struct pel_point base;
    int32_t x, from, to;
};

/* Sets a line along `direction` from one place to another, in the outline's
 * direction: the shape lies on its right. */
void pel_smooth_line_set(struct pel_smooth_line *line, struct pel_point base,
                         struct pel_point direction,
                         struct pel_smooth_place from,
                         struct pel_smooth_place to);

/* Adds to a window what lies right of it. */
void pel_smooth_bow_add(struct pel_smooth_bow *bow,
                        struct pel_smooth_window *window);
void pel_smooth_line_add(const struct pel_smooth_line *line,
                         struct pel_smooth_window *window);
void pel_smooth_gap_add(const struct pel_smooth_gap *gap,
                        struct pel_smooth_window *window);

#endif
