/* The rows of smooth rounds: of a disc, or of one that is pulled apart to a
 * rounded rectangle. */
#ifndef PEL_SMOOTH_ROUND_ROWS_H
#define PEL_SMOOTH_ROUND_ROWS_H

#include "disc_side.h"
#include "smooth_row.h"

/* The centres of its four quarters, 1/256 px. */
struct pel_smooth_round {
    int32_t left, right, top, bottom; /* left <= right, top <= bottom */
    int32_t radius;
};

/* A circle around each of them, row by row. */
struct pel_smooth_disc {
    struct pel_smooth_circle circle;
    int32_t at, next; /* where it is at the upper end of a row, and at the lower
                         one of a whole strip */
};

struct pel_smooth_rows {
    struct pel_smooth smooth; /* first */
    struct pel_smooth_round round;
    struct pel_smooth_disc disc;
    struct pel_span rows; /* that are left */
    struct pel_span rest; /* columns of the row above them that are left */
    int32_t image_y;      /* a row and its image add up to it */
    bool twins;           /* rows are painted with their images */
    bool twin_columns;    /* the left side mirrors the right one, by columns */
    bool inside;          /* no column is clipped away */
    struct pel_smooth_batch batch;
};

/* Begins with `round`, of legal coordinates; false: nothing is visible. */
bool pel_smooth_rows_begin(struct pel_smooth_rows *rows,
                           const struct pel_surface *surface,
                           const struct pel_paint *paint);

/* Sets `at` for row y. */
void pel_smooth_disc_go(struct pel_smooth_disc *disc,
                        const struct pel_smooth_round *round, int32_t y);

/* Sets the strip of row y, which is next, but for what pel_smooth_strip_set
 * does, if the circle crosses the row from
 * its upper end to the lower one on either side; or false. */
bool pel_smooth_disc_strip(struct pel_smooth_disc *disc,
                           const struct pel_smooth_round *round, int32_t y,
                           struct pel_smooth_strip *strip);

/* The columns that the left side crosses in row y, and the right one. */
void pel_smooth_disc_reach(const struct pel_smooth_disc *disc,
                           const struct pel_smooth_round *round, int32_t y,
                           struct pel_span reach[2]);

/* Adds the areas inside, 2^-15 px modulo 2^16, in at most PEL_SMOOTH_PIXELS
 * columns of row y. */
void pel_smooth_disc_add(const struct pel_smooth_disc *disc,
                         const struct pel_smooth_round *round, int32_t y,
                         const struct pel_span *columns, uint16_t *sum);

/* Makes a batch of the next rows, up to `end`, that are whole strips: how many.
 */
int32_t pel_smooth_rows_batch(struct pel_smooth_rows *rows, int32_t end);

/* Moves on by a row that is not, whose columns are left; and makes a batch of
 * the first of them, the `left` ones. */
void pel_smooth_rows_pass(struct pel_smooth_rows *rows);
void pel_smooth_rows_rest(struct pel_smooth_rows *rows,
                          struct pel_smooth_columns *columns);

/* Is the last row of the batch its own image? */
static inline bool pel_smooth_is_own_image(const struct pel_smooth_rows *rows)
{
    const struct pel_smooth_batch *const b = &rows->batch;
    return b->n > 0 && 2 * (b->y + b->n - 1) == rows->image_y;
}

/* Paints the batch, and its image, if there is one. */
void pel_smooth_rows_paint(struct pel_smooth_rows *rows);

/* Paints all. */
void pel_smooth_rows_all(struct pel_smooth_rows *rows);

#endif
