/* Where pel view shows its pictures. */
#ifndef SIM_VIEW_DISPLAYS_H
#define SIM_VIEW_DISPLAYS_H

#include "sim/cli/device.h"
#include "sim/view/viewer.h"

struct view_job {
    const struct model *model;
    const struct scene_settings *settings; /* a size of 0x0: any will do */
    const struct viewer_options *options;
    const struct device_options *device;
};

/* Shows the model in a window, until the user or options->frames ends it; what
 * was seen is told on standard error then. False, with a message: in a build
 * without SDL2, which names its package, too. */
bool view_window(const struct view_job *job);

/* The same on job->device, with keys from the terminal: in the middle of the
 * screen, black around it. */
bool view_device(const struct view_job *job);

/* For the two: prints the keys when there is a user. */
void view_tell_keys(const struct viewer_options *options);

/* Threads of their pool for --jobs N. */
int view_jobs(int jobs);

#endif
