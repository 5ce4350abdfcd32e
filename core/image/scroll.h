/* Scrolling: moves pixels inside a surface. */
#ifndef PEL_IMAGE_SCROLL_H
#define PEL_IMAGE_SCROLL_H

#include "../base/surface.h"

PEL_BEGIN_DECLS

/* What a scroll leaves to be painted anew, without overlap: the lines above or
 * below what moved, and the columns beside it. */
struct pel_exposed {
    struct pel_rect rect[2];
    int32_t n; /* 0, 1 or 2 */
};

/* Moves the picture inside `area` (and inside the clip) by dx px to the right
 * and dy px down. What moves out is lost. Pixels that nothing moved to keep
 * their color, and their place is returned. The result is as if all pixels
 * moved at once: source and destination may overlap. Pixels move as they are in
 * the formats of 8 bits and more; in the others, one by one. dx and dy lie in
 * -65,536..65,536 (otherwise nothing moves; PEL_ASSERT). */
struct pel_exposed pel_scroll(const struct pel_surface *surface,
                              const struct pel_rect *area, int32_t dx,
                              int32_t dy);
PEL_END_DECLS
#endif
