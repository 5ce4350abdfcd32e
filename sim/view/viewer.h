/* A show with its clock and its input: what the window, the device and the
 * files of pel view have in common. A display does, until viewer_is_over:
 *
 *     viewer_input(viewer, event): tell what the user does
 *     viewer_advance(viewer)
 *     where viewer->stale: viewer_draw(viewer, surface), show it
 *     wait for input, for viewer_idle(viewer) ms at most
 */
#ifndef SIM_VIEW_VIEWER_H
#define SIM_VIEW_VIEWER_H

#include "port/linux/input.h"
#include "sim/cli/device.h"
#include "sim/view/show.h"

struct viewer_options {
    int frames;          /* to draw, and then to end; 0: until the user ends */
    int width, height;   /* px; 0: any will do */
    const char *output;  /* for the last picture; NULL: none */
    const char *buttons; /* see port/linux/buttons.h; NULL: none */
    const char *record;  /* a file for what the user does, or NULL */
    const char *replay;  /* a file that was recorded, or NULL */
    bool headless;       /* frames go to files in the folder `output` */
    const struct device_options *device;
};

struct viewer {
    struct show *show;
    const struct viewer_options *options; /* the caller's */
    struct pel_input_linux input;         /* or not open */
    FILE *record;            /* NULL before there is something to write */
    int size[2];             /* px of what is drawn: its width and height */
    int pointer[2];          /* px of it */
    bool has_pointer;        /* a mouse or a tablet has told where it is */
    bool pointed;            /* and has moved since this was made false */
    bool stale;              /* there is something new to draw */
    bool over;               /* the user ended it */
    bool moves;              /* did the last advance change it? */
    int drawn;               /* frames */
    int steps;               /* of time */
    double begun, last, due; /* ms: the first frame, the last step, the next */
    double drawing;          /* ms spent on drawing, all frames */
    struct {
        double since, drawing; /* ms */
        int drawn;
        double fps, milliseconds; /* of the last second; 0: not known */
    } rate;
};

void viewer_init(struct viewer *viewer, struct show *show,
                 const struct viewer_options *options);
void viewer_free(struct viewer *viewer);

/* A new size of what is drawn. False, with a message. */
bool viewer_resize(struct viewer *viewer, int width, int height);

/* Opens the devices and buttons that a window does not have. False, with a
 * message. */
bool viewer_open_input(struct viewer *viewer,
                       const struct pel_input_linux_options *options);

/* Handles an event, and records it; where that fails, with a message, the show
 * is over. True when the picture is to be written, with viewer_save.
 */
bool viewer_input(struct viewer *viewer, const struct pel_input *event);

/* The same for all that came from what viewer_open_input opened. */
bool viewer_inputs(struct viewer *viewer);

/* Lets the time pass; first prints the keys when there is a user. */
void viewer_advance(struct viewer *viewer);

/* How many ms a display may wait for input before it calls viewer_advance. */
int viewer_idle(const struct viewer *viewer);

/* Draws the next frame onto the clip of a surface. False, with a message. */
bool viewer_draw(struct viewer *viewer, const struct pel_surface *surface);

bool viewer_is_over(const struct viewer *viewer);

/* Writes what was drawn last to options->output, if that is there; or, after
 * 'w', to a new file, whose name is printed. False, with a message. */
bool viewer_save(const struct viewer *viewer, const struct pel_surface *surface,
                 bool last);

/* A line for the window's frame: what is shown, and how fast it is drawn. */
enum { VIEWER_TITLE_SIZE = SHOW_TITLE_SIZE + 96 };
void viewer_title(const struct viewer *viewer, char title[VIEWER_TITLE_SIZE]);

/* Frames, their rate and the time of drawing in all, on standard error. */
void viewer_report(const struct viewer *viewer);

/* Shows it in a window, until the user or options->frames ends it; prints what
 * was seen on standard error then. False, with a message: in a build without
 * SDL2, which names its package, too. */
bool view_window(struct show *show, const struct viewer_options *options);

/* The same on options->device, with keys from the terminal: in the middle of
 * the screen, black around it. */
bool view_device(struct show *show, const struct viewer_options *options);

/* The first key (enum pel_key) of what a terminal has sent, *used of `count` >=
 * 1 bytes: arrows and F keys as CSI or SS3 sequences, Escape as a byte that no
 * sequence follows. */
int view_terminal_key(const char *bytes, size_t count, size_t *used);

/* options->frames frames into files of the folder options->output, with what
 * the user did from options->replay. False, with a message. */
bool view_headless(struct show *show, const struct viewer_options *options);

#endif
