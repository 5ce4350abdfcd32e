/* A view on its scene, with a clock: what the window and the device of pel view
 * have in common. A display does, until viewer_is_over:
 *
 *     viewer_input(viewer, event): tell what the user does
 *     viewer_advance(viewer)
 *     where viewer->stale: viewer_draw(viewer, surface), show it,
 *                          viewer_shown(viewer)
 */
#ifndef SIM_VIEW_VIEWER_H
#define SIM_VIEW_VIEWER_H

#include "port/linux/input.h"
#include "port/linux/pool.h"
#include "sim/cli/device.h"
#include "sim/view/view.h"
#include "sim/view/keys.h"

struct viewer_options {
    int frames;          /* to draw, and then to end; 0: until the user ends */
    bool has_step;       /* not by the clock: */
    double step;         /* turns of the model from frame to frame */
    const char *output;  /* for the last picture; NULL: none */
    bool still;          /* no turning at the start */
    const char *buttons; /* see port/linux/buttons.h; NULL: none */
};

struct view_job {
    const struct model *model;
    const struct scene_settings *settings; /* a size of 0x0: any will do */
    const struct viewer_options *options;
    const struct device_options *device;
};

struct viewer {
    struct view view;
    const struct viewer_options *options; /* the caller's, like the model */
    const struct model *model;
    struct scene scene;
    struct pel_pool pool;
    struct pel_input_linux input; /* or not open */
    int width, height;            /* px of what was drawn */
    bool dragging;                /* the pointer's button is held */
    int16_t x, y;                 /* where a finger or a tablet's pointer was */
    bool stale;                   /* there is something new to draw */
    bool over;                    /* the user ended it */
    int drawn;                    /* frames */
    double begun, last; /* ms: the first frame, the last viewer_advance */
    double drawing;     /* ms spent on drawing, all frames */
    struct {
        double since, drawing; /* ms */
        int drawn;
        double fps, milliseconds; /* of the last second; 0: not known */
    } rate;
};

/* Starts the threads, when the display is open; `settings` are the job's with a
 * size. False, with a message. viewer_free in any case. */
bool viewer_init(struct viewer *viewer, const struct view_job *job,
                 const struct scene_settings *settings);
void viewer_free(struct viewer *viewer);

/* Opens the devices and buttons that a window does not have. False, with a
 * message. */
bool viewer_open_input(struct viewer *viewer,
                       const struct pel_input_linux_options *options);

/* Handles an event: keys, a drag with the first button or finger, the wheel.
 * True when the picture is to be written, with viewer_save_new. */
bool viewer_input(struct viewer *viewer, const struct pel_input *event);

/* The same for all that came from what viewer_open_input opened. */
bool viewer_inputs(struct viewer *viewer);

/* Lets the time pass; first prints the keys when there is a user. True when the
 * title has changed. */
bool viewer_advance(struct viewer *viewer);

/* Clears the surface and draws a picture of the size of its clip, side by side
 * on the threads of the pool. False, with a message. */
bool viewer_draw(struct viewer *viewer, const struct pel_surface *surface);

/* The frame that was drawn is seen. */
void viewer_shown(struct viewer *viewer);

bool viewer_is_over(const struct viewer *viewer);

/* Writes what was drawn to options->output, if that is there; after 'w' to a
 * new file, whose name is printed. False, with a message. */
bool viewer_save_last(const struct viewer *viewer,
                      const struct pel_surface *surface);
bool viewer_save_new(const struct pel_surface *surface);

/* What is seen, and how fast: "60.0 fps, 3.1 ms, ...". */
enum { VIEWER_TITLE_SIZE = 160 };
void viewer_title(const struct viewer *viewer, char title[VIEWER_TITLE_SIZE]);

/* Frames, their rate and the time of drawing in all, on standard error. */
void viewer_report(const struct viewer *viewer);

/* Shows the model in a window, until the user or options->frames ends it;
 * prints what was seen on standard error then. False, with a message: in a
 * build without SDL2, which names its package, too. */
bool view_window(const struct view_job *job);

/* The same on job->device, with keys from the terminal: in the middle of the
 * screen, black around it. */
bool view_device(const struct view_job *job);

#endif
