/* The cases: each has its function, atlas_NAME, and is called so with '-' for
 * '_'. One that ends in -time has figures of time alone (run.sh). */
#ifndef BENCH_ATLAS_CASES_H
#define BENCH_ATLAS_CASES_H

#include "atlas.h"

#define ATLAS_CASES(X)                                                        \
    X(damage), X(damage_time), X(thinness), X(snapping), X(overflow),         \
        X(map_sliver), X(color), X(color_sliver), X(gradient), X(span),       \
        X(map_perspective), X(phong), X(map_phong), X(order), X(fighting),    \
        X(alpha), X(hsv), X(dither), X(arctangent), X(circle), X(map_circle), \
        X(limits), X(sampling), X(gamma), X(tolerance), X(tolerance_time),    \
        X(smooth_discs), X(smooth_needles), X(smooth_time), X(smooth_seams)

#define ATLAS_FUNCTION(name) atlas_##name(struct atlas *a)
void ATLAS_CASES(ATLAS_FUNCTION);

#endif
