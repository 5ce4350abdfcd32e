/* Linear gradients:
 *
 *     static const pel_color blues[2] = {PEL_RGB(10, 20, 60),
 *                                        PEL_RGB(40, 120, 190)};
 *     static const struct pel_ramp ramp = {blues, 2, PEL_PAD};
 *     struct pel_linear sky;
 *     if (pel_linear_init(&sky, top, bottom, &ramp) == PEL_OK)
 *         pel_circle(&surface, center, radius, &sky.base.paint);
 *
 * On formats of 16 bits and less wrap it in a dither (paint_dither.h), or its
 * steps are seen. */
#ifndef PEL_PAINT_PAINT_LINEAR_H
#define PEL_PAINT_PAINT_LINEAR_H

#include "color_ramp.h"
#include "paint_colors.h"

PEL_BEGIN_DECLS

/* The colour at a point P is that of the ramp at t = (P - from).(to - from) /
 * |to - from|^2: 0 at `from`, 1 at `to`, level across the way. t is a plane,
 * stepped in 64 bits from pixel (0, 0), with as many fraction bits as its range
 * leaves. It is never too small, and too large by less than 2^-16 sub-pixel
 * along the way plus 2^-32 of it, everywhere. */
struct pel_linear {
    struct pel_color_paint base;
    struct pel_ramp ramp;
    uint64_t at, dx, dy; /* 2^-bits of the way, two's complement */
    uint8_t bits;
};

/* Opaque when all colours of the ramp are, as they are now.
 * PEL_ERROR_NULL, PEL_ERROR_SIZE (the ramp's n, or from and to are one point),
 * PEL_ERROR_RANGE (a point out of range). */
enum pel_status pel_linear_init(struct pel_linear *paint, struct pel_point from,
                                struct pel_point to,
                                const struct pel_ramp *ramp);
PEL_END_DECLS
#endif
