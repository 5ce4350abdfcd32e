/* A mesh that the user turns: a show for pel view. */
#ifndef SIM_VIEW_TURNTABLE_H
#define SIM_VIEW_TURNTABLE_H

#include "port/linux/pool.h"
#include "sim/view/keys.h"
#include "sim/view/show.h"
#include "sim/view/view.h"

struct turntable {
    struct show show; /* first */
    struct view view;
    const struct model *model; /* the caller's, like the settings */
    const struct scene_settings *settings;
    struct scene scene;
    struct pel_pool pool;
    bool has_step;     /* not by the clock: */
    double step;       /* turns of the model from frame to frame */
    int width, height; /* px of the picture; 0 before the first */
    bool dragging;     /* the pointer's button is held */
    int16_t x, y;      /* where a finger or the pointer was */
};

/* Starts `jobs` threads that draw, 0 for one a processor. The settings' size
 * does not matter. False, with a message; turntable_free in any case. */
bool turntable_init(struct turntable *turntable, const struct model *model,
                    const struct scene_settings *settings, int jobs);
void turntable_free(struct turntable *turntable);

#endif
