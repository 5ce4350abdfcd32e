/* Where the two ends of an arc are: the pixels near them, and which of the
 * others, those of the ring, belong to the arc.
 *
 * The ring is seen as two halves, right and left of its centre, each from its
 * top down. A ray that has been passed on the way makes what was outside of the
 * arc inside. It is passed in rows below it, and in its own rows, where the
 * pixels that it touches lie, on that side of these.
 *
 * The ray begins a pixel inside of the hole: so pixels that the hole cuts in
 * two, of which it parts the halves, are near to it. */
#ifndef PEL_SMOOTH_ARC_ENDS_H
#define PEL_SMOOTH_ARC_ENDS_H

#include "../round/arc.h"
#include "outline.h"

struct pel_smooth_end {
    struct pel_rect ray;  /* px: around the pixels that it touches */
    struct pel_rect disc; /* px: around a round end, or empty */
    struct pel_rect box;  /* of both */
    int32_t slope;        /* of the ray, to the next row, 2^-shift */
    uint8_t shift;        /* 15, or 0 along a row */
    bool right, up;
};

struct pel_smooth_ends {
    struct pel_point center;
    bool top; /* belongs what is just left of the centre's top? */
    struct pel_smooth_end end[2];
};

/* A point on the ray of a direction. */
struct pel_smooth_place pel_smooth_place_at(struct pel_point direction,
                                            int32_t radius);

/* The centre of a round end. */
struct pel_point pel_smooth_end_center(const struct pel_arc_shape *arc,
                                       uint16_t angle);

/* Of a legal arc with outer > inner, between angles that differ. */
void pel_smooth_ends_set(struct pel_smooth_ends *ends,
                         const struct pel_arc_shape *arc, bool round);

/* The columns near an end in a row; false: none. */
bool pel_smooth_end_columns(const struct pel_smooth_ends *ends, int i,
                            int32_t y, struct pel_span *columns);

/* How much of a part of the ring, in some rows and columns, is in the arc. */
enum pel_smooth_share {
    PEL_SMOOTH_NONE,
    PEL_SMOOTH_ALL,
    PEL_SMOOTH_NEAR /* some, or an end is near */
};

enum pel_smooth_share pel_smooth_ends_share(const struct pel_smooth_ends *ends,
                                            const struct pel_rect *part);

/* Paints what belongs to the arc, and is not near an end, of a part of one of
 * the ring's rows. */
void pel_smooth_ends_paint(const struct pel_smooth_ends *ends,
                           const struct pel_smooth *smooth,
                           const struct pel_smooth_row *row);

#endif
