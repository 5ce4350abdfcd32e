/* Conic gradients: colors by angle around a centre, and the wheel of hues. */
#ifndef PEL_PAINT_PAINT_CONIC_H
#define PEL_PAINT_PAINT_CONIC_H

#include "gradient.h"

PEL_BEGIN_DECLS

/* The gradient runs clockwise on screen, once around from the angle `start`.
 * Cell k of n holds the pixels that pel_sector, with a radius that reaches
 * them, holds between the angles
 *
 *     start + floor(65536 k / n) and start + floor(65536 (k + 1) / n)
 *
 * (round/sector.h; the only cell of n = 1 holds all): on the ray of the first
 * or clockwise of it, and before the ray of the second. A pixel whose centre is
 * the gradient's counts as angle 0. PEL_PAD and PEL_REPEAT are the same; with
 * PEL_REFLECT the colors go there and back within the turn: in 2 n cells. */
struct pel_conic {
    struct pel_gradient base;
    struct pel_point center;
    uint16_t start;    /* turns / 65,536, clockwise from +x */
    int32_t width;     /* of a cell, rounded down, in turns / 65,536 */
    int32_t remainder; /* of the turn: 65,536 - width * period */
};

/* PEL_ERROR_NULL, PEL_ERROR_SIZE (the ramp's n), PEL_ERROR_RANGE (the centre
 * out of range). */
enum pel_status pel_conic_init(struct pel_conic *paint, struct pel_point center,
                               uint16_t start, const struct pel_ramp *ramp);

/* The HSV wheel: a conic of 1,536 cells, 256 in each sixth of the turn, so that
 * one channel moves by at most one step from cell to cell. Cell k has the color
 * of the hue in its middle, (k + 1/2) / 1,536 turns, rounded as pel_hsv rounds:
 * no ramp, and no memory for one. Shapes take its conic.base.paint. */
struct pel_hue_wheel {
    struct pel_conic conic;
    uint8_t s, v;
};

/* PEL_ERROR_NULL, PEL_ERROR_RANGE (the centre out of range). */
enum pel_status pel_hue_wheel_init(struct pel_hue_wheel *paint,
                                   struct pel_point center, uint16_t start,
                                   uint8_t s, uint8_t v);

PEL_END_DECLS

#endif
