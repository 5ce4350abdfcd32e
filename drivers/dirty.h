/* Dirty areas: where a picture has changed, as a few rectangles, and a redraw
 * of these alone.
 *
 *     static struct pel_dirty_areas dirty = {.window = 64};
 *     static uint16_t band[2][240 * 8];
 *     const struct pel_dirty_work work = {{band[0], band[1]}, sizeof band[0],
 *                                         draw_picture, &state};
 *     pel_dirty_areas_add(&dirty, &old_place);
 *     pel_dirty_areas_add(&dirty, &new_place);
 *     pel_dirty_areas_show(&dirty, &display, &work);
 *
 * pel_dirty (core/raster/dirty.h) finds the box of a shape. */
#ifndef PEL_DRIVERS_DIRTY_H
#define PEL_DRIVERS_DIRTY_H

#include "display.h"

PEL_BEGIN_DECLS

enum { PEL_DIRTY_AREAS = 8 };

struct pel_dirty_areas {
    /* What an area costs beside its pixels, in pixels: the commands of a window
     * and the set-up of shapes. Two areas become their box where that costs
     * less, or where there are more than PEL_DIRTY_AREAS. */
    int32_t window;
    int32_t count;
    struct pel_rect area[PEL_DIRTY_AREAS + 1]; /* px; the last one is spare */
};

/* Adds what of an area is inside 0..32,767; an empty one is nothing. */
void pel_dirty_areas_add(struct pel_dirty_areas *dirty,
                         const struct pel_rect *area);

/* How a picture is drawn. */
struct pel_dirty_work {
    /* Memory of bands, for a display that has none of its own: `size` bytes
     * each, aligned as the format asks. With two, one is drawn while the other
     * is sent; NULL for the second: one. */
    void *memory[2];
    size_t size;

    /* Draws the whole picture onto a surface that holds a part of it. */
    void (*draw)(void *context, const struct pel_surface *surface);
    void *context;
};

/* Draws and sends the areas in bands, flips, and empties the list. On a display
 * of n pages the areas are to be those of the last n frames. Errors of the
 * display; PEL_ERROR_SCRATCH: the memory is too small for the narrowest band
 * that the display accepts. The list stays after an error. */
enum pel_status pel_dirty_areas_show(struct pel_dirty_areas *dirty,
                                     const struct pel_display *display,
                                     const struct pel_dirty_work *work);
PEL_END_DECLS
#endif
