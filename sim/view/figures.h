/* How pel view paints shapes; and its figures, circles and polygons that turn,
 * as the items of a scene script for any size of picture. */
#ifndef SIM_VIEW_FIGURES_H
#define SIM_VIEW_FIGURES_H

#include <stdbool.h>
#include <stdint.h>

#include "core/base/color.h"
#include "core/base/rect.h"
#include "sim/script/script.h"

/* How a shape is painted: items of a scene script that come before it. */
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

enum { OUTLINE_CORNERS = 10 };

/* The shape that a paint is for, in px. */
struct outline {
    double x, y, r; /* its middle, and how far it reaches */
    double corner[OUTLINE_CORNERS][2];
    int corners;
    double turn, phase;
};

/* These add items to a script. False, with a message, when memory is short. */

/* A paint other than FILL_OWN, and its options. */
bool style_add(struct script *script, const struct style *style,
               const struct outline *outline);

/* A paint of the script with its colors as the style has them. */
bool style_recolor(struct script *script, const struct style *style,
                   const struct script_item *paint);

enum { FIGURES = 9 };

/* Where the figures are at a moment. */
struct figures {
    int width, height; /* px of the picture */
    double turn;       /* of all around the middle, in turns */
    double phase;      /* of radial fills, 0 to 1 */
    bool dithered, smooth;
};

/* The size and the figures of a script: figure 0 first, the largest one, and so
 * on with falling area, so that none hides a smaller one. Figure k takes
 * style[k]. */
bool figures_add(struct script *script, const struct figures *figures,
                 const struct style style[FIGURES]);

/* The pixels around figure k. */
struct pel_rect figures_box(const struct figures *figures, int k);

/* The styles that the figures begin with. */
void figures_styles(struct style style[FIGURES]);

#endif
