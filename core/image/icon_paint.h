/* The seam between icons and their gradients. */
#ifndef PEL_IMAGE_ICON_PAINT_H
#define PEL_IMAGE_ICON_PAINT_H

#include "../path/path.h"
#include "icon.h"

/* u or v of a gradient in 2^-24, modulo 2^64: at the centre of pixel (x, y) it
 * is at + x * axis.x + y * axis.y. */
struct pel_icon_axis {
    uint64_t at, x, y;
};

struct pel_icon_paint {
    struct pel_paint paint;
    const struct pel_icon_gradient *gradient;
    const struct pel_icon_stop *stop; /* its first */
    struct pel_icon_axis u, v;
};

struct pel_icon_gradients {
    /* Makes the paint of a gradient; false: out of range. */
    bool (*make)(struct pel_icon_paint *paint,
                 const struct pel_icon_gradient *gradient,
                 const struct pel_icon_shape *shape);
};

#endif
