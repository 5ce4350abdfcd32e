/* How pel view paints a shape: lines of a scene script that come before it. */
#ifndef SIM_VIEW_STYLE_H
#define SIM_VIEW_STYLE_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "core/base/color.h"

enum fill {
    FILL_OWN,     /* the paint that the script has there */
    FILL_FLAT,    /* one color */
    FILL_CORNERS, /* barycentric: a color at each corner */
    FILL_RADIAL,  /* rings that repeat, with a phase */
    FILL_SECTOR   /* by angle: the hues */
};

struct style {
    enum fill fill;
    pel_color color; /* of FILL_FLAT and FILL_RADIAL; alpha ignored */
    uint8_t alpha;   /* 255: opaque; on top of that of FILL_OWN's colors */
    bool marked;     /* in another color: the picked one */
};

/* The shape that a paint is for, in px. */
struct outline {
    double x, y, r; /* its middle, and how far it reaches */
    double corner[16][2];
    int corners; /* 3 to 16 */
    double turn, phase;
};

/* Writes the lines of a paint other than FILL_OWN. */
void style_write(FILE *out, const struct style *style,
                 const struct outline *outline);

/* Writes a line of a script with its colors as the style has them. */
void style_recolor(FILE *out, const struct style *style, const char *line);

#endif
