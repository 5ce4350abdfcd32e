/* Spans of a disc, row by row: the pixels whose centre lies within, exactly.
 * circle.c walks the same sides itself.
 *
 * A row holds the columns at a distance u from the centre with
 * u^2 <= half_width2. That is radius^2 - v^2 for a circle, v the distance of
 * the row; for an ellipse it is scaled (ellipse_walk.h). Each side is walked by
 * Bresenham's scheme: the next column outwards belongs to it when
 * d = floor((half_width2 - u^2) / 512) >= 0. From column to column u^2 grows by
 * (u + 256)^2 - u^2 = 512 (u + 128), so the bits that the floor drops never
 * change, and u + 128 is subtracted from d without a multiplication.
 *
 * A side begins at the visible column nearest to the centre and has visible
 * columns only. A row takes one step for each column by which it differs from
 * the row before.
 *
 * The disc may be pulled apart: the left side around left_x, the right one
 * around right_x >= left_x, and all columns between them. Then half_width2 must
 * not be negative; in a plain disc a negative one gives an empty span.
 *
 * Ranges: |u| and |v| at most 2^25, |half_width2| below 2^52. */
#ifndef PEL_ROUND_DISC_H
#define PEL_ROUND_DISC_H

#include "../base/format.h"
#include "../base/point.h"

struct pel_disc_sides {
    int64_t d[2]; /* left and right: of the next column outwards */
    int32_t u[2]; /* its distance, 1/256 px */
};

/* Adds or removes columns of a side until d and u are those of the row; at most
 * `limit` columns. */
static PEL_ALWAYS_INLINE void pel_disc_side_adjust(int64_t *d, int32_t *u,
                                                   int32_t *columns,
                                                   int32_t limit)
{
    if (*d < 0) {
        for (; *columns > 0 && *d + *u - 128 < 0; --*columns) {
            *u -= 256;
            *d += *u + 128;
        }
        return;
    }
    for (; *d >= 0 && *columns < limit; ++*columns) {
        *d -= *u + 128;
        *u += 256;
    }
}

struct pel_disc {
    struct pel_disc_sides sides;
    int32_t center[2]; /* of each, 1/256 px */
};

static inline void pel_disc_center(struct pel_disc *disc, int32_t left_x,
                                   int32_t right_x)
{
    disc->center[0] = left_x;
    disc->center[1] = right_x;
}

/* Starts at a row in the columns of `clip`. */
void pel_disc_sides_start(struct pel_disc_sides *sides, const int32_t center[2],
                          const struct pel_rect *clip, int64_t half_width2);

/* The visible span of the row; the same clip as at the start. */
void pel_disc_sides_row(struct pel_disc_sides *sides, const int32_t center[2],
                        const struct pel_rect *clip, struct pel_span *span);

/* Moves to a row whose half_width2 is larger by 512 * change. */
static inline void pel_disc_sides_step(struct pel_disc_sides *sides,
                                       int32_t change)
{
    sides->d[0] += change;
    sides->d[1] += change;
}

/* The same; after pel_disc_center. */
static inline void pel_disc_start(struct pel_disc *disc,
                                  const struct pel_rect *clip,
                                  int64_t half_width2)
{
    pel_disc_sides_start(&disc->sides, disc->center, clip, half_width2);
}

static inline void pel_disc_row(struct pel_disc *disc,
                                const struct pel_rect *clip,
                                struct pel_span *span)
{
    pel_disc_sides_row(&disc->sides, disc->center, clip, span);
}

/* Moves from a row with one half_width2 to a row with another. */
void pel_disc_change(struct pel_disc *disc, int64_t from, int64_t to);

/* The rows of a disc around one centre. */
struct pel_disc_walk {
    struct pel_disc disc;    /* at row visible.y0 */
    struct pel_rect visible; /* the rows that are left, and their columns */
};

/* The rows of a ring: a disc, and the sides of the hole inside at the same row,
 * around the same centre. */
struct pel_ring_walk {
    struct pel_disc_walk outer;
    struct pel_disc_sides hole;
};

/* Sets what is visible of the disc's square. false: nothing is, or the disc is
 * out of range (PEL_ASSERT). */
bool pel_disc_walk_box(struct pel_disc_walk *w, const struct pel_point *center,
                       int32_t radius, const struct pel_rect *clip);

/* The visible span of the hole's row. */
static inline void pel_ring_hole(struct pel_ring_walk *w, struct pel_span *span)
{
    pel_disc_sides_row(&w->hole, w->outer.disc.center, &w->outer.visible, span);
}

/* Starts at the first row that is visible. */
void pel_disc_walk_begin(struct pel_disc_walk *w,
                         const struct pel_point *center, int32_t radius);

static inline bool pel_disc_walk_ended(const struct pel_disc_walk *w)
{
    return w->visible.y0 >= w->visible.y1;
}

/* The visible span of the row. */
static inline void pel_disc_walk_row(struct pel_disc_walk *w,
                                     struct pel_span *span)
{
    pel_disc_row(&w->disc, &w->visible, span);
}

/* Moves on to the next row, with a distance v + 256: half_width2 shrinks by
 * 512 (v + 128). */
static inline void pel_disc_walk_next(struct pel_disc_walk *w,
                                      const struct pel_point *center)
{
    w->visible.y0++;
    pel_disc_sides_step(&w->disc.sides, center->y - 256 * w->visible.y0);
}

/* True when the whole clip lies in the hole: when its corner that is farthest
 * from the centre does. */
static inline bool pel_ring_around(const struct pel_point *center,
                                   int32_t inner, const struct pel_rect *clip)
{
    const int32_t x =
        pel_max(center->x - clip->x0 * 256, clip->x1 * 256 - center->x);
    const int32_t y =
        pel_max(center->y - clip->y0 * 256, clip->y1 * 256 - center->y);
    return pel_square(x) + pel_square(y) <= pel_square(inner);
}

/* As pel_disc_walk_box and pel_disc_walk_begin. */
static inline bool pel_ring_box(struct pel_ring_walk *w,
                                const struct pel_point *center, int32_t inner,
                                int32_t outer, const struct pel_rect *clip)
{
    PEL_ASSERT(pel_radius_legal(inner));
    return pel_radius_legal(inner) &&
           pel_disc_walk_box(&w->outer, center, outer, clip) &&
           !pel_ring_around(center, inner, clip);
}

static inline void pel_ring_begin(struct pel_ring_walk *w,
                                  const struct pel_point *center, int32_t inner,
                                  int32_t outer)
{
    pel_disc_walk_begin(&w->outer, center, outer);
    const int32_t v = pel_pixel_center(w->outer.visible.y0) - center->y;
    pel_disc_sides_start(&w->hole, w->outer.disc.center, &w->outer.visible,
                         pel_square(inner) - pel_square(v));
}

static inline void pel_ring_next(struct pel_ring_walk *w,
                                 const struct pel_point *center)
{
    pel_disc_walk_next(&w->outer, center);
    pel_disc_sides_step(&w->hole, center->y - 256 * w->outer.visible.y0);
}

#endif
