/* The picture of pel view at a moment: settings as they were given, and changes
 * by the user since. No input, no output: calls say what keys, mouse and clock
 * do. */
#ifndef SIM_VIEW_VIEW_H
#define SIM_VIEW_VIEW_H

#include "sim/render/scene.h"

struct view {
    struct scene_settings first;    /* at the start, with a framed camera */
    struct scene_settings settings; /* first, but for what keys change: shade,
                                       texture, terms, order, lit */
    unsigned dark;                  /* bit i: light i + 1 is switched off */
    double spin;  /* turns of the model around its y axis; its front moves to
                     the right */
    double tilt;  /* turns by which the camera was raised around its target */
    double zoom;  /* 1: as at the start; larger is closer */
    bool turning; /* spin grows with time */
    bool lit;     /* is there light? For the one who prepares scenes to tell:
                     see enum scene_lit */
};

/* Frames the camera of `settings` for their size. False, with a message, when
 * it cannot be placed. */
bool view_init(struct view *view, const struct scene_settings *settings,
               const struct model *model);

/* Back to the start; turning goes on or stays off, and begins at 0. */
void view_reset(struct view *view);

/* Settings for a picture of width x height pixels: what the first size showed
 * is seen in any. Of the first size and before any change they are the first
 * ones, so that `pel render` draws the same bytes. */
void view_settings(const struct view *view, int width, int height,
                   struct scene_settings *settings);

/* Turns the model by `right` turns and raises the camera by `up`, not farther
 * than close to the zenith or nadir of its target. */
void view_orbit(struct view *view, double right, double up);

/* Comes closer by a factor, within 1/8 to 8 of the first distance. */
void view_zoom(struct view *view, double factor);

#endif
