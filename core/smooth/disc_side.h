/* The sides of discs in a row of pixels, and the part of each pixel that lies
 * between them.
 *
 * A row cuts a disc into strips: one above the height of its centre, or one
 * below, or both. The arc enters a strip and leaves it at two distances from
 * the axis, at_near >= at_far, and crosses the columns between them. The left
 * side is the right one of the mirrored picture.
 *
 *           axis
 *            |-- at_far --.
 *      far   +------------*.
 *            |                `*.
 *      near  +------------------*
 *            |----- at_near ----|
 *
 * Distances are in 2^-16 px. Areas are in 2^-15 of a pixel, modulo 2^16. */
#ifndef PEL_SMOOTH_DISC_SIDE_H
#define PEL_SMOOTH_DISC_SIDE_H

#include "../base/format.h"
#include "../base/point.h"

/* What belongs to a radius. */
struct pel_smooth_circle {
    int32_t radius;   /* 1/256 px */
    int32_t shift;    /* of the square of the radius to 30..32 bits */
    uint32_t bulge;   /* what a piece of the arc is long; 2^20 / 12 radius px */
    uint32_t inverse; /* 2^28 / radius, from 40 px on; else 2^20 / radius */
};

struct pel_smooth_strip {
    const struct pel_smooth_circle *circle;
    int32_t near, far;       /* 0 <= near < far, at most a pixel more */
    int32_t at_near, at_far; /* where the arc is there */
    uint32_t bulge;          /* of a piece 1 px wide, 2^-20 px */
    bool steep;              /* such a piece is so long along y */
    bool small;              /* each piece of the arc has its bulge */
};

/* The radius must be legal. */
void pel_smooth_circle_set(struct pel_smooth_circle *circle, int32_t radius);

/* How far from one axis the arc is at a distance from the other, 1/256 px. */
int32_t pel_smooth_arc_at(const struct pel_smooth_circle *circle,
                          int32_t distance);

/* Sets `bulge`, `steep` and `small` of a strip that has the rest. */
void pel_smooth_strip_set(struct pel_smooth_strip *strip);

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

/* How many columns a side has, if one of them is from x0 on before x1. */
static inline int32_t pel_smooth_seen(const struct pel_span *side, int32_t x0,
                                      int32_t x1)
{
    return side->x0 < x1 && side->x1 > x0 ? side->x1 - side->x0 : 0;
}

/* 0..255 of a sum of areas, which is off by less than 64. */
static inline uint8_t pel_smooth_coverage(uint32_t sum)
{
    return (uint8_t)((((sum + 64) & 0xFFFF) * 255 + 16384 - 64 * 255) >> 15);
}

/* Sets the areas of n columns from x on: what is between the axis and the arc.
 * A column on the other side of the axis is not asked for; that which holds it
 * counts as a whole. */
void pel_smooth_strip_areas(const struct pel_smooth_strip *strip,
                            int32_t center, int32_t x, int32_t n,
                            uint16_t *area);

/* The coverage of all columns that the side of a strip crosses which is a pixel
 * high, into `to` and on by `step`, 1 or -1; hole: of what is outside. */
void pel_smooth_whole_side(const struct pel_smooth_strip *strip, int32_t center,
                           bool hole, uint8_t *to, int32_t step);

#endif
