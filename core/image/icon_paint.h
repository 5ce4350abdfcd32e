/* The seam between icons and their gradients. */
#ifndef PEL_IMAGE_ICON_PAINT_H
#define PEL_IMAGE_ICON_PAINT_H

#include "../path/path.h"
#include "../raster/plane.h"
#include "icon.h"

enum { PEL_ICON_RUN = 8 };

/* Pixels of a row on their way to the surface, from the one at x on. */
struct pel_icon_run {
    uint64_t u, v;
    int32_t x, end;
    pel_color colors[PEL_ICON_RUN];
};

struct pel_icon_paint {
    struct pel_paint paint;
    struct pel_icon_run *run; /* memory for one, as stacks are small */
    const struct pel_icon_gradient *gradient;
    const struct pel_icon_stop *stop; /* its first */
    struct pel_plane u, v;            /* of the gradient, in 2^-24 */
};

struct pel_icon_gradients {
    /* Makes the paint of a gradient, whose run is set; false: out of range. */
    bool (*make)(struct pel_icon_paint *paint,
                 const struct pel_icon_gradient *gradient,
                 const struct pel_icon_shape *shape);
};

#endif
