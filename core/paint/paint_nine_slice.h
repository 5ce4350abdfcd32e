/* Nine-slice pictures: buttons, panels and bubbles of any size from one small
 * picture. Its corners stay as they are, its edges grow along the box, and its
 * middle grows both ways:
 *
 *       x0  x1              +--+--------+--+
 *     +--+--+--+            |  |        |  |
 *  y0 +--+--+--+   becomes  +--+--------+--+
 *  y1 +--+--+--+            |  |        |  |
 *     |  |  |  |            +--+--------+--+
 *     +--+--+--+            |  |        |  |
 *                           +--+--------+--+
 *
 *     pel_nine_slice_init(&button, &picture, &middle, &box);
 *     pel_box(&screen, &box, &button.base.paint); */
#ifndef PEL_PAINT_PAINT_NINE_SLICE_H
#define PEL_PAINT_PAINT_NINE_SLICE_H

#include "paint_colors.h"

PEL_BEGIN_DECLS

/* One direction, in px: the box begins at `from` and is `size` long; of the
 * picture so many are before the middle, in it, and behind it. */
struct pel_nine_slice_side {
    int32_t from, size;
    int32_t before, middle, behind;
};

struct pel_nine_slice {
    struct pel_color_paint base;
    const struct pel_surface *picture;
    struct pel_nine_slice_side across, down;
    bool tiled; /* edges and middle are repeated from the left and top on,
                   instead of stretched, each pixel the texel at its centre;
                   false at first */
};

/* The picture, of any format with a `load`, and its alpha if it has one, must
 * live as long as the paint. `middle`, in px as its bounds are, is not empty
 * and inside its bounds; `box`, in px of the screen, is one that a surface may
 * have (pel_bounds_legal). In a box too small for both corners the left and
 * upper ones are in front. Outside of the box nothing is painted.
 * PEL_ERROR_NULL, PEL_ERROR_FORMAT (the picture cannot be read),
 * PEL_ERROR_RANGE (middle, box). */
enum pel_status pel_nine_slice_init(struct pel_nine_slice *paint,
                                    const struct pel_surface *picture,
                                    const struct pel_rect *middle,
                                    const struct pel_rect *box);
PEL_END_DECLS
#endif
