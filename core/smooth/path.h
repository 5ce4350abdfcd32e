/* Smooth outlines of arcs and lines, by the area that lies right of each piece:
 * a row is painted from the left to the right, and where pieces cross pixels
 * their areas add up. */
#ifndef PEL_SMOOTH_PATH_H
#define PEL_SMOOTH_PATH_H

#include "disc_side.h"
#include "round_strips.h"
#include "smooth.h"

struct pel_smooth_path_place {
    int32_t x, y; /* 2^-16 px from a centre */
};

/* Part of a circle, clockwise on screen from one place to another through some
 * quadrants, of which 0 begins at +x. */
struct pel_smooth_path_arc {
    struct pel_point center;
    struct pel_smooth_path_place from, to;
    uint8_t first, count; /* quadrants */
    bool hole;            /* the outline goes backwards */
    struct pel_smooth_circle circle;
    int32_t most;  /* how far above or below the centre it goes, 2^-16 px */
    int32_t v[2];  /* the ends of the row, 2^-16 px below the centre */
    int32_t at[2]; /* where the circle is there */
};

/* Where a line goes: through a place, that far from `base`. */
struct pel_smooth_way {
    struct pel_point base, direction; /* direction.y != 0 */
    struct pel_smooth_path_place offset;
};

/* The part of it between two heights. */
struct pel_smooth_path_side {
    struct pel_smooth_way way;
    int64_t top, bottom; /* 2^-16 px */
    int32_t first, last; /* rows */
    int32_t row;         /* the present one */
    int64_t x[2];        /* at its ends, 2^-16 px from the base */
    bool left;           /* the shape is right of it */
};

struct pel_smooth_path {
    struct pel_smooth smooth;
    struct pel_smooth_row row; /* what waits to be painted */
    uint8_t coverage[2 * PEL_SMOOTH_WINDOW];
    int32_t bows, lines;
    struct pel_smooth_path_arc bow[4];
    struct pel_smooth_path_side line[4];
};

/* Sides of a row: up to 5 of a circle, as many of another one, 3 of each of two
 * half circles, and the lines. */
enum { PEL_SMOOTH_SIDES = 20 };

/* Begins an empty path; false: nothing is drawn. */
bool pel_smooth_path_begin(struct pel_smooth_path *path,
                           const struct pel_surface *surface,
                           const struct pel_paint *paint);

/* Adds a bow, of which the first six members are set. */
void pel_smooth_path_bow(struct pel_smooth_path *path,
                         const struct pel_smooth_path_arc *bow, int32_t radius);

/* Adds a line from one height to another, 2^-16 px, in the outline's direction:
 * the shape lies on its right. */
void pel_smooth_path_line(struct pel_smooth_path *path,
                          const struct pel_smooth_way *way, int64_t from,
                          int64_t to);

/* Paints what is in the box, px, around all that is covered. */
void pel_smooth_path_paint(struct pel_smooth_path *path,
                           const struct pel_rect *box);

/* A piece in a row, seen as a right side of the mirrored picture, if need be.
 */
struct pel_smooth_piece_side {
    struct pel_smooth_strip strip;
    int32_t center; /* 1/256 px */
    bool left;      /* mirrored */
    bool rising;    /* what is right of it belongs to the shape */
};

/* Goes to row y, the first one or the next, after a start there. */
void pel_smooth_path_start(struct pel_smooth_path *path, int32_t y);
void pel_smooth_path_row(struct pel_smooth_path *path, int32_t y);

/* The number of the piece after number `id` that may be in the row, the first
 * one after -1, and -1 after the last. */
int32_t pel_smooth_path_next(const struct pel_smooth_path *path, int32_t y,
                             int32_t id);

/* That piece in the row; false: none of it. */
bool pel_smooth_path_piece(const struct pel_smooth_path *path, int32_t y,
                           int32_t id, struct pel_smooth_piece_side *side);

/* As pel_smooth_strip_areas, of a line, which has no circle, and whose
 * distances are in 2^-13 px. */
void pel_smooth_line_areas(const struct pel_smooth_strip *strip, int32_t center,
                           int32_t x, int32_t n, uint16_t *area);

#endif
