/* What pel view shows, seen from what shows it: a window, a device, files. */
#ifndef SIM_VIEW_SHOW_H
#define SIM_VIEW_SHOW_H

#include "drivers/dirty.h"
#include "drivers/input.h"
#include "sim/image/canvas.h"

enum view_action {
    VIEW_NOTHING, /* nothing has changed */
    VIEW_CHANGED,
    VIEW_SAVE, /* the present picture is to be written */
    VIEW_END
};

enum { SHOW_TITLE_SIZE = 160 };

struct show {
    /* The size in px of what is drawn, before the first frame and whenever it
     * changes. False, with a message, when nothing can be drawn. */
    bool (*resize)(struct show *show, int width, int height);

    /* What the user does. */
    enum view_action (*input)(struct show *show, const struct pel_input *input);

    /* Time passes, in ms. True when the picture changes. */
    bool (*advance)(struct show *show, double time);

    /* Draws a frame onto the clip of a surface, which has the size of the last
     * resize. False, with a message. */
    bool (*draw)(struct show *show, const struct pel_surface *surface);

    /* px of the surface that differ from the frame before: all of the clip,
     * unless draw makes it less. */
    struct pel_dirty_areas changed;

    /* What is seen, in a line. */
    void (*title)(const struct show *show, char title[SHOW_TITLE_SIZE]);

    const char *keys;  /* and what they do, a line each */
    double period;     /* ms from frame to frame; 0: as fast as it goes */
    double draw_time;  /* ms for the last frame; the viewer sets this one */
    int late;          /* and this: frames that came too late */
    int width, height; /* px of a window, unless the user wants others */
};

#endif
