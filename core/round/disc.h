/* The exact walk over the rows of a disc: for every row the run of pixels whose
 * centre lies within. Rings, sectors, ellipses, the corners of rounded
 * rectangles, and outlines share it; a filled circle makes rows of its own from
 * the same walk of one side (disc_side.h).
 *
 * In row y the disc holds the columns at a distance u from its centre with
 * u^2 <= reach, where reach is radius^2 - v^2 for a circle and v the distance
 * of the row; for an ellipse it is scaled (ellipse_walk.h). Each side of the
 * run is a walk over columns by Bresenham's scheme: the next column outwards
 * joins when d = floor((reach - u^2) / 512) >= 0. From column to column u^2
 * changes by (u + 256)^2 - u^2 = 512 (u + 128), so the bits that the floor
 * drops never change: the walk subtracts u + 128 and never multiplies.
 *
 * The walk is bounded by the clip: it begins at the column of the clip that is
 * nearest to the centre and takes no column that is not visible. From row to
 * row the run changes by as many columns as the walk takes steps.
 *
 * The disc may be pulled apart: the left side around left_x, the right one
 * around right_x >= left_x, and all columns between them. Then reach must not
 * be negative; in a plain disc a negative reach gives an empty run.
 *
 * Ranges: |u| and |v| at most 2^25, |reach| below 2^52. */
#ifndef PEL_ROUND_DISC_H
#define PEL_ROUND_DISC_H

#include "../base/point.h"
#include "../base/format.h"

struct pel_disc_side {
    int64_t d;      /* of the next column outwards */
    int32_t u;      /* its distance */
    int32_t center; /* 1/256 px */
};

struct pel_disc {
    struct pel_disc_side left, right;
};

/* (v + 256)^2 - v^2: what one row further out takes from the reach. */
static inline int64_t pel_square_step(int32_t v)
{
    return (int64_t)v * 512 + 65536;
}

static inline void pel_disc_center(struct pel_disc *disc, int32_t left_x,
                                   int32_t right_x)
{
    disc->left.center = left_x;
    disc->right.center = right_x;
}

/* At a row with this reach, for the columns of `clip`; after the centre. */
void pel_disc_start(struct pel_disc *disc, const struct pel_rect *clip,
                    int64_t reach);

/* The visible run of the present row; the same clip as at the start. */
void pel_disc_row(struct pel_disc *disc, const struct pel_rect *clip,
                  struct pel_span *span);

/* Moves on to a row whose reach is 512 * change greater. */
static inline void pel_disc_step(struct pel_disc *disc, int32_t change)
{
    disc->left.d += change;
    disc->right.d += change;
}

/* Moves on from a row with one reach to a row with another. */
void pel_disc_change(struct pel_disc *disc, int64_t from, int64_t to);

#endif
