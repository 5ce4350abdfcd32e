/* What pel view shows, seen from what shows it: a window, a device, files. */
#ifndef SIM_VIEW_SHOW_H
#define SIM_VIEW_SHOW_H

#include "drivers/input.h"
#include "sim/image/canvas.h"
#include "sim/view/keys.h"

struct show {
    /* The window's size in px, before the first frame and whenever it changes.
     */
    void (*resize)(struct show *show, int width, int height);

    /* What the user does. */
    enum view_action (*input)(struct show *show, const struct pel_input *input);

    /* A frame's time passes, in ms. True when the picture changes. */
    bool (*advance)(struct show *show, double time);

    /* Draws a frame. False, with a message. */
    bool (*draw)(struct show *show, const struct pel_surface *surface);

    /* What is seen, in a line of at most SHOW_TITLE_SIZE - 1 bytes. */
    void (*title)(const struct show *show, char *title);

    const char *keys; /* and what they do, a line each */
};

enum { SHOW_TITLE_SIZE = 160 };

struct headless_options {
    const char *directory; /* of the frames, frame-0000.ppm and so on */
    const char *replay;    /* a record (record.h), or NULL */
    int frames, width, height;
};

/* Draws frames into files, a frame's time from one to the next. False, with a
 * message. */
bool view_headless(struct show *show, const struct headless_options *options);

#endif
