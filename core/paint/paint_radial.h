/* Radial gradients: rings around a centre. */
#ifndef PEL_PAINT_PAINT_RADIAL_H
#define PEL_PAINT_PAINT_RADIAL_H

#include "color_ramp.h"
#include "curve.h"
#include "paint_colors.h"

PEL_BEGIN_DECLS

/* The colour at distance r from the centre is that of the ramp at
 * t = r / radius + phase / 65,536. A falling phase moves the rings outwards. */
struct pel_rings {
    struct pel_point center;
    int32_t radius; /* 1/256 px, 256..PEL_PX(32767) */
    uint16_t phase; /* 65,536ths of the way */
};

/* r is off by less than 1/256 px, and t by less than 2^-11: jumps are where
 * they belong within 1/256 px, and the colour is within 1 of the exactly
 * rounded one when the ramp has as many cells as its slope (color_ramp.h), up
 * to 1,000.
 *
 * Distances are computed exactly (integer square root, rounded down to 1/16,384
 * px) at the ends of pieces and joined by cubics (curve.h), to 1/512 px since
 * |r''''| <= 3 / r^3 along a row. */
struct pel_radial {
    struct pel_color_paint base;
    struct pel_curve curve;
    struct pel_ramp ramp;
    uint64_t phase; /* 2^-bits of the way; bits of the curve */
    uint32_t scale; /* 2^-bits of the way in 1/64 sub-pixel */
};

/* Opaque when all colours of the ramp are, as they are now.
 * PEL_ERROR_NULL, PEL_ERROR_SIZE (the ramp's n), PEL_ERROR_RANGE (centre or
 * radius out of range). */
enum pel_status pel_radial_init(struct pel_radial *paint,
                                const struct pel_rings *rings,
                                const struct pel_ramp *ramp);
PEL_END_DECLS
#endif
