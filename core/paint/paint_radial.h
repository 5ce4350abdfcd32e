/* Radial gradients: rings around a centre. */
#ifndef PEL_PAINT_PAINT_RADIAL_H
#define PEL_PAINT_PAINT_RADIAL_H

#include "gradient.h"

PEL_BEGIN_DECLS

/* The offset is the distance from the centre in radii, plus the phase: a
 * falling phase moves the rings outwards. */
struct pel_rings {
    struct pel_point center;
    int32_t radius; /* 1/256 px, 256..PEL_PX(32767) */
    uint16_t phase; /* of the offset, 65,536ths */
};

/* Ring k, from 0 on, is that of pel_ring around the centre with the radii
 * floor(k radius / n) and floor((k + 1) radius / n) in sub-pixels, for all k,
 * beyond the radius too; the pixel on the centre itself belongs to ring 0. It
 * shows cell k + floor(phase n / 65,536) of n, by the ramp's spread. */
struct pel_radial {
    struct pel_gradient base;
    struct pel_rings rings;
    int32_t first;            /* cell of ring 0 */
    int32_t width, remainder; /* radius = width n + remainder */
    uint32_t low; /* the square of every pixel's distance modulo 512 */
};

/* PEL_ERROR_NULL, PEL_ERROR_SIZE (the ramp's n), PEL_ERROR_RANGE (centre or
 * radius out of range). */
enum pel_status pel_radial_init(struct pel_radial *paint,
                                const struct pel_rings *rings,
                                const struct pel_ramp *ramp);

/* The square of a pixel's distance from the centre. */
int64_t pel_radial_square(const struct pel_radial *paint, int32_t x, int32_t y);

/* The fill of spans with narrow rings, by tables in 21 KB of stack; or
 * false, and nothing is done. Only where PEL_FAST_FILLS and PEL_64BIT are 1
 * (core/fast). */
bool pel_radial_fast(const struct pel_radial *paint,
                     const struct pel_spans *spans);

PEL_END_DECLS

#endif
