/* A window of some columns of a row, in which the areas of an outline's pieces
 * are added up: what lies right of each, since the shape lies right of pieces
 * that go up and left of those that go down. */
#ifndef PEL_SMOOTH_WINDOW_H
#define PEL_SMOOTH_WINDOW_H

#include "disc_side.h"
#include "smooth.h"
#include "smooth_edge.h"

/* Columns of a window. */
enum { PEL_SMOOTH_COLUMNS = PEL_SMALL_CODE ? 8 : 16 };

struct pel_smooth_window {
    int32_t y, x, n; /* columns from x on */
    int32_t used;    /* of them, up to the last one that a piece crosses */
    int32_t next;    /* the first one behind it that a piece crosses */
    int32_t sum[PEL_SMOOTH_COLUMNS + 1]; /* what each has more than the one
                                            before it, and what those up to
                                            `next` have, 2^-15 px */
};

/* A part of a line in a row, from one x to another. */
struct pel_smooth_line_piece {
    int32_t base;       /* 1/256 px: where the left one is .. */
    uint32_t low, high; /* .. and so far right of that, 2^-16 px */
    int32_t h;          /* 2^-16 px */
    struct pel_rise rise;
};

/* Sets the first three from both ends, 2^-16 px right of a place, in any order.
 */
static inline void pel_smooth_line_piece_set(
    struct pel_smooth_line_piece *piece, int32_t place, int64_t a, int64_t b)
{
    const int64_t left = a < b ? a : b, right = a < b ? b : a;
    const int32_t whole = (int32_t)(left >> 8);
    piece->base = place + whole;
    piece->low = left & 255;
    piece->high = (uint32_t)(right - left) + piece->low;
}

/* Begins a window of a row from x on, which ends before `end`. */
void pel_smooth_window_begin(struct pel_smooth_window *window, int32_t y,
                             int32_t x, int32_t end);

/* A side of a shape in a row: the columns that it crosses, of the mirrored
 * picture if `left`. */
struct pel_smooth_crossing {
    struct pel_span columns;
    int32_t height; /* 2^-15 px */
    bool left, rising;
};

/* Leaves the columns that are in the window; false: none. */
bool pel_smooth_window_find(struct pel_smooth_window *window,
                            struct pel_smooth_crossing *crossing);

/* Adds what lies right of the side, or takes it away: rising. The areas are
 * those left of it in the columns that were found. */
void pel_smooth_window_add(struct pel_smooth_window *window,
                           const struct pel_smooth_crossing *crossing,
                           const uint16_t *area);

/* Finds and adds a piece of a line. */
void pel_smooth_window_line(struct pel_smooth_window *window,
                            const struct pel_smooth_line_piece *piece,
                            bool rising);

/* The same of a strip's right side in the picture that is mirrored if `left`,
 * around a centre in that one. Sets what pel_smooth_strip_set does. */
void pel_smooth_window_strip(struct pel_smooth_window *window,
                             struct pel_smooth_strip *strip, int32_t center,
                             bool left, bool rising);

/* Paints what the sums say, a pixel at most, up to `next`. */
void pel_smooth_window_paint(const struct pel_smooth_window *window,
                             struct pel_smooth *smooth);

#endif
