/* Conic gradients: colours by angle around a centre. */
#ifndef PEL_PAINT_PAINT_CONIC_H
#define PEL_PAINT_PAINT_CONIC_H

#include "color_ramp.h"
#include "curve.h"
#include "paint_colors.h"

/* The colour at an angle is that of the ramp at t = angle - start, in turns
 * from 0 to 1, clockwise on screen (base/trig.h). PEL_PAD and PEL_REPEAT
 * are the same; PEL_REFLECT goes there and back within the turn, without a
 * seam. A pixel centre on the centre counts as angle 0.
 *
 * The angle is off by less than 1e-5 turns, and its ray by less than 1/256 px
 * at every distance: so one method serves every tolerance. Angles are computed
 * to 2^-30 turns (base/turn.h) at the ends of pieces and joined by cubics
 * (curve.h), to 1/512 px and 1e-5 turns since |a''''| <= 6 / r^4 along a row.
 */
struct pel_conic {
    struct pel_color_paint base;
    struct pel_curve curve;
    struct pel_ramp ramp;
    uint32_t start; /* 2^-32 turns */
};

/* Opaque when all colours of the ramp are, as they are now. start: 65,536ths of
 * a turn. PEL_ERROR_NULL, PEL_ERROR_SIZE (the ramp's n), PEL_ERROR_RANGE (the
 * centre out of range). */
enum pel_status pel_conic_init(struct pel_conic *paint, struct pel_point center,
                               uint16_t start, const struct pel_ramp *ramp);

/* The same with colours of its own: `run` colours a walk in 2^-64 turns and
 * gets the paint's curve (PEL_CURVE_PAINT leads to the paint, with which a
 * larger struct may begin); ramp is not set, opaque is true. PEL_ERROR_NULL,
 * PEL_ERROR_RANGE. */
enum pel_status pel_conic_begin(struct pel_conic *paint,
                                struct pel_point center, uint16_t start,
                                pel_curve_run *run);

#if PEL_FAST_64BIT

/* The colours of a run; `context` is for the run function, `paint` a struct
 * pel_conic. */
void pel_conic_colors(const struct pel_color_paint *paint, const void *context,
                      const struct pel_run *run, pel_color *colors);

#endif
#endif
