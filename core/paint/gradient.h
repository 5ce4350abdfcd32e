/* Gradients: cells of equal color, drawn as shapes of one color.
 *
 * A ramp of n colors, not 2, cuts the offsets from 0 to 1 into n equal cells;
 * cell i, [i/n, (i+1)/n), shows color[i]. pel_ramp_fill() sets each to the
 * gradient's exactly rounded color in the middle of its cell. So
 *  - the color is off by at most slope / (2 n) + 1/2 steps, where slope is the
 *    largest change of a channel per unit of offset: within 1 of the exactly
 *    rounded color when n >= slope / 2 (two stops: 128 colors; the six of a
 *    rainbow: 768);
 *  - a hard stop at a multiple of 1/n is exact, others move by half a cell;
 *  - the ends are the first and the last stop's color when n > slope.
 *
 * A ramp of two colors mixes them: 256 cells, each with the exactly
 * rounded color of its middle, as of pel_ramp_fill(), without an array.
 *
 * The cells go on at both ends as the spread says. Each kind of gradient says
 * exactly which pixels a cell holds (paint_linear.h, paint_radial.h,
 * paint_conic.h). Nothing is rounded: bands, tiles, clips, formats and CPUs
 * change no byte. */
#ifndef PEL_PAINT_GRADIENT_H
#define PEL_PAINT_GRADIENT_H

#include "../raster/paint.h"

PEL_BEGIN_DECLS

/* What a gradient shows outside [0, 1). Other values are not checked. */
enum pel_spread {
    PEL_PAD,    /* its first and its last color */
    PEL_REPEAT, /* itself, again and again: t - floor(t) */
    PEL_REFLECT /* there and back */
};

struct pel_ramp {
    const pel_color *colors; /* the caller's; must live as long as the paint */
    int32_t n;               /* 1..32,767; 2: they are mixed */
    enum pel_spread spread;
};

struct pel_stop {
    int32_t at; /* 0..65,536: the offset, 65,536ths, not falling */
    pel_color color;
};

/* Sets n colors from `count` stops, linear between neighbours, channel by
 * channel, alpha too. Before the first stop and after the last theirs stay. Two
 * stops at one offset are a hard edge; there the later one is shown.
 * PEL_ERROR_NULL, PEL_ERROR_SIZE (n or count outside 1..32,767),
 * PEL_ERROR_RANGE (a position out of range or falling). */
enum pel_status pel_ramp_fill(pel_color *colors, int32_t n,
                              const struct pel_stop *stops, int32_t count);

/* The first member of every gradient. */
struct pel_gradient {
    struct pel_paint paint;

    /* The color at an index, 0 <= index < period. Up to `cells` it is a cell;
     * from there on cells come back: index period - 1 - i shows cell i. */
    pel_color (*color)(const struct pel_gradient *gradient, int32_t index);

    struct pel_ramp ramp;
    int32_t cells;  /* n, and 256 of two colors */
    int32_t period; /* cells until they begin anew; n where they do not */
};

/* Sets all but the paint. PEL_ERROR_NULL, PEL_ERROR_SIZE (the ramp's n). */
enum pel_status pel_gradient_init(struct pel_gradient *gradient,
                                  const struct pel_ramp *ramp);

PEL_END_DECLS

#endif
