/* Patterns of two colors: checkers, and hatches of parallel lines. They lie at
 * absolute pixels, so shapes side by side share one, and a phase that grows
 * from frame to frame moves it (a selection's marching ants). Either color may
 * have any alpha; 0 shows what is below. */
#ifndef PEL_PAINT_PAINT_PATTERN_H
#define PEL_PAINT_PAINT_PATTERN_H

#include "paint_colors.h"

PEL_BEGIN_DECLS

/* Fields of width x height px, 1..32,767, one of which begins at (x, y), any
 * number of px. It and its neighbours by a corner are `on`. */
struct pel_checker_fields {
    int32_t width, height;
    int32_t x, y;
};

/* Pixel (x, y) is `on` where (dx x + dy y + phase) mod period < width. dx and
 * dy lie in -255..255: (1, 0) makes upright lines `width` px wide, (0, 1) level
 * ones, (1, 1) ones that rise at 45 degrees, (1, -1) ones that fall; (2, 1)
 * ones that rise twice as fast. period 1..32,767, width 0..period, any phase.
 */
struct pel_hatch_lines {
    int32_t dx, dy, phase;
    int32_t period, width;
};

struct pel_checker {
    struct pel_color_paint base;
    struct pel_checker_fields fields;
    pel_color on, off;
};

struct pel_hatch {
    struct pel_color_paint base;
    struct pel_hatch_lines lines;
    pel_color on, off;
};

/* PEL_ERROR_NULL, PEL_ERROR_RANGE (the numbers above). */
enum pel_status pel_checker_init(struct pel_checker *paint,
                                 const struct pel_checker_fields *fields,
                                 pel_color on, pel_color off);
enum pel_status pel_hatch_init(struct pel_hatch *paint,
                               const struct pel_hatch_lines *lines,
                               pel_color on, pel_color off);
PEL_END_DECLS
#endif
