/* The sides of shapes in a row of pixels, and the part of each pixel that lies
 * left of them.
 *
 * A row cuts a shape into strips: of a disc one above the height of its centre,
 * or one below, or both. An arc enters a strip and leaves it at two distances
 * from the axis, at_near >= at_far, and crosses the columns between them. The
 * left side is the right one of the mirrored picture.
 *
 *           axis
 *            |-- at_far --.
 *      far   +------------*.
 *            |                `*.
 *      near  +------------------*
 *            |----- at_near ----|
 *
 * Lines are straight arcs, around an axis that is near. Distances are in 2^-16
 * px. Areas are in 2^-15 of a pixel. */
#ifndef PEL_SMOOTH_STRIP_H
#define PEL_SMOOTH_STRIP_H

#include "../base/format.h"
#include "../base/point.h"
#include "smooth.h"

/* A piece of an arc from (u0, v0) to (u1, v1), u0 <= u1 and v0 >= v1, from the
 * centre. */
struct pel_smooth_arc_piece {
    int32_t u0, v0, u1, v1;
};

/* What an ellipse has of its own, whose arcs are seen as a circle's of its
 * upright radius. */
struct pel_smooth_oval {
    /* How far from one axis the arc is at a distance from the other, 1/256 px:
     * from the upright one by what it is from the level one, or `down`. At 0
     * from the level one it is its radius. */
    int32_t (*at)(const struct pel_smooth_oval *oval, int32_t distance,
                  bool down);
    /* The area between a piece and its chord, 2^-15 px. */
    uint32_t (*bulge)(const struct pel_smooth_oval *oval,
                      const struct pel_smooth_arc_piece *piece);
};

/* `down` of an oval. */
enum { PEL_SMOOTH_OVAL = 255 };

/* What belongs to a radius, and the quarters of its circle that a shape has. */
struct pel_smooth_circle {
    int32_t radius; /* 1/256 px */
    union {
        uint32_t inverse; /* 2^(20 + down) / radius */
        const struct pel_smooth_oval *oval;
    } of;
    uint8_t down;         /* bits of the radius beyond 40 px; or OVAL */
    uint8_t first, count; /* quadrants, clockwise; 0 begins at +x */
    bool hole;            /* the outline goes backwards */
};

/* How much a line moves down, by how much it moves along x: rise 2^-15 times
 * what is shifted up and down. */
struct pel_smooth_slope {
    uint32_t rise;
    uint8_t up, down;
};

struct pel_smooth_strip {
    const struct pel_smooth_circle *circle; /* NULL: a line, .. */
    struct pel_smooth_slope slope;          /* .. which has this */
    int32_t near, far;       /* 0 <= near < far, at most a pixel more */
    int32_t at_near, at_far; /* where the arc is there */
#if !PEL_SMOOTH_TINY
    uint32_t bulge; /* 0, or of an arc that goes along an axis for a pixel */
#endif
};

/* All four quarters of a legal radius, forwards, and no oval; all but the
 * inverse. */
void pel_smooth_circle_set(struct pel_smooth_circle *circle, int32_t radius);
void pel_smooth_circle_begin(struct pel_smooth_circle *circle, int32_t radius);

/* The inverse alone. */
uint32_t pel_smooth_circle_inverse(int32_t radius);

/* How far it is from the upright axis, 2^-16 px. */
int32_t pel_smooth_reach(const struct pel_smooth_circle *circle);

/* How far from one axis the arc is at a distance from the other, 1/256 px: see
 * pel_smooth_oval. */
int32_t pel_smooth_arc_at(const struct pel_smooth_circle *circle,
                          int32_t distance, bool down);

/* Of a line that moves so far in a row, px 2^-32. */
void pel_smooth_slope_set(struct pel_smooth_slope *slope, uint64_t step);

/* The height of a strip. */
static inline int32_t pel_smooth_height(const struct pel_smooth_strip *strip)
{
    return (strip->far - strip->near) >> 1;
}

/* The column of a distance from the centre at x. */
static inline int32_t pel_smooth_column(int32_t x, int32_t distance)
{
    return (x + (distance >> 8)) >> 8;
}

/* The columns that the arc crosses. */
static inline struct pel_span pel_smooth_crossed(
    const struct pel_smooth_strip *strip, int32_t center)
{
    const struct pel_span span = {pel_smooth_column(center, strip->at_far),
                                  pel_smooth_column(center, strip->at_near) +
                                      1};
    return span;
}

/* 0..255 of a sum of areas and 64: it is off by less than that. */
static inline uint8_t pel_smooth_coverage_of(uint32_t sum)
{
    return (uint8_t)(((sum & 0xFFFF) * 255 + 16384 - 64 * 255) >> 15);
}

static inline uint8_t pel_smooth_coverage(uint32_t sum)
{
    return pel_smooth_coverage_of(sum + 64);
}

/* Goes on to the piece of the column whose inner boundary is at u: from that of
 * the column before, or one that has u1 = INT32_MIN. */
void pel_smooth_go_on(const struct pel_smooth_strip *strip, int32_t u,
                      struct pel_smooth_arc_piece *piece);

/* What lies between the axis and a piece in its column. */
uint32_t pel_smooth_area(const struct pel_smooth_strip *strip, int32_t u,
                         const struct pel_smooth_arc_piece *piece);

/* Both. */
static inline uint32_t pel_smooth_column_area(
    const struct pel_smooth_strip *strip, int32_t u,
    struct pel_smooth_arc_piece *piece)
{
    pel_smooth_go_on(strip, u, piece);
    return pel_smooth_area(strip, u, piece);
}

/* A side of a whole row. Not where PEL_SMOOTH_TINY is 1. */
struct pel_smooth_side {
    const struct pel_smooth_strip *strip;
    int32_t center;
    int32_t x; /* its first column in the row that it was found in */
    const struct pel_smooth_side *image; /* its mirror image, whose bytes are
                                            its own backwards; or NULL */
    const uint8_t *at; /* a byte of coverage for each column that it crosses, */
    int32_t bytes;     /* or none: they are out of sight */
    uint32_t flip; /* all ones where what lies beyond the arc is covered, .. */
    uint32_t more; /* .. and what is added to the flipped area of a pixel */
    int32_t step;  /* to the next column from its axis: 1, or -1 on the left */
    bool rising;   /* as of a crossing (outline.h) */
};

/* Writes the coverage of all columns of a side. */
void pel_smooth_side_cover(const struct pel_smooth_side *side, uint8_t *to);

#endif
