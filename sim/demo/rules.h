/* The cases of the fill rule. */
#ifndef SIM_DEMO_RULES_H
#define SIM_DEMO_RULES_H

#include <stdbool.h>

#include "core/base/color.h"

enum { RULES_WIDTH = 12, RULES_HEIGHT = 10 }; /* px of the canvas of a case */

/* Vertices lie on quarters of pixels, so that many centres are on edges. */
struct rules_case {
    const char *caption;
    uint8_t v[12 * 6]; /* x, y of three vertices each, in 1/4 px */
    int count;         /* triangles */
    bool line;         /* draw those without area as lines */
};

/* All cases; the last has no caption. */
extern const struct rules_case rules_cases[];

/* A drawn case as it is seen, the top row first: the colors, and how often
 * each pixel was painted. */
struct rules_pixels {
    pel_color color[RULES_HEIGHT][RULES_WIDTH];
    uint8_t hits[RULES_HEIGHT][RULES_WIDTH];
};

/* Draws a case on a surface with a positive stride (y down) or a negative one
 * (y up). */
void rules_draw(const struct rules_case *rules, bool y_up,
                struct rules_pixels *pixels);

#endif
