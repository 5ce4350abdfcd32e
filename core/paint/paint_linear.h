/* Linear gradients:
 *
 *     static const pel_color blues[2] = {PEL_RGB(10, 20, 60),
 *                                        PEL_RGB(40, 120, 190)};
 *     static const struct pel_ramp ramp = {blues, 2, PEL_PAD};
 *     struct pel_linear sky;
 *     if (pel_linear_init(&sky, top, bottom, &ramp) == PEL_OK)
 *         pel_circle(&surface, center, radius, &sky.base.paint);
 *
 * On formats of 16 bits and less its steps are seen. A dither (paint_dither.h)
 * hides them: pel_dither_init(&smooth, &sky.base.paint), then draw with
 * &smooth.paint. */
#ifndef PEL_PAINT_PAINT_LINEAR_H
#define PEL_PAINT_PAINT_LINEAR_H

#include "gradient.h"

PEL_BEGIN_DECLS

/* Cell k of n holds the pixels whose centre P satisfies
 *
 *     k |d|^2 <= n (P - from).d < (k + 1) |d|^2,    d = to - from,
 *
 * in sub-pixels, exactly: the offset is 0 at `from`, 1 at `to`. Across d the
 * color stays. */
struct pel_linear {
    struct pel_gradient base;

    /* Both ends change places where d.x would be below 0, or d.y where d.x is
     * 0: products grow to the right, or downwards. Where code is to be small a
     * vertical gradient is not turned. */
    struct pel_point from, d;
    int64_t square; /* |d|^2 = 256 n cell + cell_remainder; small code does not
                       set these two */
    int64_t cell;
    int64_t step; /* 256 n d.x: by which n products grow from pixel to pixel */
    int32_t cell_remainder;
    int32_t direction; /* 1, or -1 when turned; 0 in small code where all of a
                          row is in one cell */
};

/* PEL_ERROR_NULL, PEL_ERROR_SIZE (the ramp's n, or from and to are one point),
 * PEL_ERROR_RANGE (a point out of range). */
enum pel_status pel_linear_init(struct pel_linear *paint, struct pel_point from,
                                struct pel_point to,
                                const struct pel_ramp *ramp);

PEL_END_DECLS

#endif
