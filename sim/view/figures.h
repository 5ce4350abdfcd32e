/* The figures of pel view: circles and polygons that turn, written as a scene
 * script for any size of picture. */
#ifndef SIM_VIEW_FIGURES_H
#define SIM_VIEW_FIGURES_H

#include <stdint.h>
#include <stdio.h>

#include "core/base/rect.h"
#include "sim/view/style.h"

enum { FIGURES = 9 };

/* Where the figures are at a moment. */
struct figures {
    int width, height; /* px of the picture */
    double turn;       /* of all around the middle, in turns */
    double phase;      /* of radial fills, 0 to 1 */
    bool dithered;
};

/* The script: figure 0 first, the largest one, and so on with falling area, so
 * that none hides a smaller one. Figure k takes style[k]. */
void figures_write(FILE *out, const struct figures *figures,
                   const struct style style[FIGURES]);

/* The pixels around figure k. */
struct pel_rect figures_box(const struct figures *figures, int k);

/* The styles that the figures begin with. */
void figures_styles(struct style style[FIGURES]);

#endif
