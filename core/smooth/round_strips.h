/* The strips of a round in rows of pixels: of a disc, or of one that is pulled
 * apart to a rounded rectangle. */
#ifndef PEL_SMOOTH_ROUND_STRIPS_H
#define PEL_SMOOTH_ROUND_STRIPS_H

#include "../base/format.h"
#include "disc_side.h"

/* The centres of its four quarters, 1/256 px. */
struct pel_smooth_round {
    int32_t left, right, top, bottom; /* left <= right, top <= bottom */
    int32_t radius;
};

/* What a row holds of it: a strip above the upper centres, one between them and
 * the lower ones, one below. */
struct pel_smooth_strips {
    struct pel_smooth_circle circle;
    int32_t at; /* where the arc is at the upper end of the next row */
    int32_t n;
    struct pel_smooth_strip strip[3];
};

/* Areas that are found at a time. */
enum { PEL_SMOOTH_WINDOW = 16 };

void pel_smooth_strips_start(struct pel_smooth_strips *strips,
                             const struct pel_smooth_round *round, int32_t y);

/* For row y, the first one or the next. */
void pel_smooth_strips_row(struct pel_smooth_strips *strips,
                           const struct pel_smooth_round *round, int32_t y);

/* The height of all, 2^-15 px. */
uint32_t pel_smooth_strips_height(const struct pel_smooth_strips *strips);

/* The columns that a side crosses, of a row with strips. */
struct pel_span pel_smooth_strips_side(const struct pel_smooth_strips *strips,
                                       int32_t center);

/* As pel_smooth_strip_areas, of all strips. */
void pel_smooth_strips_areas(const struct pel_smooth_strips *strips,
                             int32_t center, int32_t x, int32_t n,
                             uint16_t *area);

#endif
