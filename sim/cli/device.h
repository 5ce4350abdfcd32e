/* Pictures on a Linux device: the options --device and --jobs, and what they
 * do. */
#ifndef SIM_CLI_DEVICE_H
#define SIM_CLI_DEVICE_H

#include "sim/cli/arguments.h"
#include "sim/image/canvas.h"
#include "drivers/dirty.h"
#include "drivers/display_linux.h"
#include "port/linux/pool.h"

struct device_options {
    const char *name; /* fb:PATH, drm:PATH or auto; NULL: no device */
    int jobs;         /* threads that draw; 0: one for each processor */
};

/* The input is a struct device_options. */
extern const struct option_row device_option_table[];

/* -o. The input is a const char *, which is NULL when left out. */
extern const struct option_row output_option_table[];

/* True when the picture may go to `output` ("-": none was named). A device and
 * a file at once may not: false, with a message. */
bool device_check_output(const struct device_options *options,
                         const char *output);

/* Draws a picture onto a canvas; on a device the canvas is a part of it,
 * whose bounds and clip are what is to be drawn. With several jobs it runs on
 * several threads at a time, and writes to nothing but the canvas. False, with
 * a message, on failure. */
typedef bool device_draw_function(struct canvas *canvas, const void *context);

/* Draws onto a canvas within its clip, in bands side by side on the threads of
 * the pool. */
bool device_draw_bands(struct pel_pool *pool, struct canvas *canvas,
                       device_draw_function *draw, const void *context);

/* Opens the device that the options name and prints its notes. False,
 * with a message. */
bool device_open(struct pel_display_linux *screen,
                 const struct device_options *options, enum pel_fb_way way);

/* Draws a frame onto a surface, which is black, and adds what is not as in the
 * frame before. False, with a message. */
typedef bool device_frame_function(struct pel_surface *surface,
                                   struct pel_dirty_areas *changed,
                                   void *context);

/* Draws one frame and shows it. False, with a message, when the device or the
 * drawing fails. */
bool device_frame(struct pel_display_linux *screen, device_frame_function *draw,
                  void *context);

/* A picture; a device sets its own pixel format. */
struct device_picture {
    int width, height; /* px */
    const struct pel_format **format;
    device_draw_function *draw;
    const void *context;
};

/* Draws a picture with the threads asked for. With a device: in the middle of
 * the screen (cut off where it is larger, black around it) until a key is
 * pressed or a signal comes; again when another terminal was shown in between.
 * Without: into the file `output`. False, with a message. */
bool device_show(const struct device_options *options,
                 const struct device_picture *picture, const char *output);

#endif
