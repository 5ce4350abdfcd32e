/* Round shapes of any kind, and the exact area of each in a pixel. */
#ifndef TESTS_SUPPORT_ROUND_AREA_H
#define TESTS_SUPPORT_ROUND_AREA_H

#include "reference_area.h"

/* A shape of random numbers. */
struct round {
    enum {
        DISC,
        RING,
        ROUNDED,
        SECTOR,
        ARC,
        ARC_ROUND,
        LINE,
        ELLIPSE,
        KINDS
    } kind;
    struct pel_point center;
    struct pel_point to;   /* of a rectangle, which begins at the centre */
    int32_t radius, inner; /* of an ellipse: along x, along y */
    int32_t from, turn;    /* angles */
};

real round_area_at(const struct round *s, int32_t x, int32_t y);

/* Is the place of an arc's round end at an angle about as near to one sub-pixel
 * as to the next? */
bool round_between_places(const struct round *s, int32_t angle);

#endif
