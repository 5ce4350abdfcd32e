/* Ramps: the colors of a gradient, in an array of the caller's.
 *
 * A ramp of n colors cuts the way from 0 to 1 into n equal cells; cell i,
 * [i/n, (i+1)/n), shows color[i]. pel_ramp_fill() sets each to the gradient's
 * exactly rounded color in the middle of its cell. So
 *  - the color is off by at most slope / (2 n) + 1/2 steps, where slope is the
 *    largest change of a channel per unit of the way: within 1 of the exactly
 *    rounded color when n >= slope / 2 (two stops: 128 colors; the six of a
 *    rainbow: 768);
 *  - a hard stop at a multiple of 1/n is exact, others move by half a cell;
 *  - the ends are the first and the last stop's color when n > slope.
 *
 * A ramp of two colors needs no array of many: they are mixed on the way, in
 * 256 cells, each with the exactly rounded color of its middle, (i + 1/2) /
 * 256: as pel_ramp_fill() would. */
#ifndef PEL_PAINT_COLOR_RAMP_H
#define PEL_PAINT_COLOR_RAMP_H

#include <stdbool.h>

#include "../base/color.h"
#include "../base/status.h"

PEL_BEGIN_DECLS

/* What a gradient shows outside [0, 1). */
enum pel_spread {
    PEL_PAD,    /* its first and its last color */
    PEL_REPEAT, /* itself, again and again: t - floor(t) */
    PEL_REFLECT /* there and back */
};

struct pel_ramp {
    const pel_color *colors; /* the caller's; must live as long as the paint */
    int32_t n;               /* 1..32,767 */
    enum pel_spread spread;
};

struct pel_stop {
    int32_t at; /* 0..65,536: 65,536ths of the way, not falling */
    pel_color color;
};

/* Sets n colors from `count` stops, linear between neighbours, channel by
 * channel, alpha too. Before the first stop and after the last theirs stay. Two
 * stops at one place are a hard edge; there the later one is shown.
 * PEL_ERROR_NULL, PEL_ERROR_SIZE (n or count outside 1..32,767),
 * PEL_ERROR_RANGE (a position out of range or falling). */
enum pel_status pel_ramp_fill(pel_color *colors, int32_t n,
                              const struct pel_stop *stops, int32_t count);

PEL_END_DECLS

#endif
