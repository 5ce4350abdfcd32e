/* The box of what is painted, in pixels: what a display has to be sent, or a
 * next picture to paint over. A filter between any shapes and their paint:
 *
 *     struct pel_dirty dirty;
 *     pel_dirty_begin(&dirty, &red.paint);
 *     pel_circle(&screen, center, radius, &dirty.paint);
 *     pel_text(&screen, &label, &dirty.paint);
 *     flush(&dirty.box);
 *
 * It is the smallest box around the pixels that the shapes cover inside the
 * clip. With NULL for the paint it is found without painting, and needs no
 * pixels: a surface of bounds and clip alone will do,
 *
 *     static const struct pel_surface measure = PEL_NO_PIXELS(240, 240);
 *
 * which takes no other paint. Unlike other paints this one has a state. */
#ifndef PEL_RASTER_DIRTY_H
#define PEL_RASTER_DIRTY_H

#include "paint.h"

PEL_BEGIN_DECLS

/* An initialiser of a surface of that size without memory and format. */
#define PEL_NO_PIXELS(width, height)                                        \
    {                                                                       \
        NULL, 0, {0, 0, (width), (height)}, {0, 0, (width), (height)}, NULL \
    }

struct pel_dirty {
    struct pel_paint paint;
    const struct pel_paint *inner;
    struct pel_rect box; /* px; empty before a pixel is covered */
};

/* `paint` must live as long as `dirty` is used; NULL paints nothing. */
void pel_dirty_begin(struct pel_dirty *dirty, const struct pel_paint *paint);
PEL_END_DECLS
#endif
