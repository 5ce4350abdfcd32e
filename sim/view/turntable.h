/* A mesh that the user turns: a show for pel view. */
#ifndef SIM_VIEW_TURNTABLE_H
#define SIM_VIEW_TURNTABLE_H

#include "port/linux/pool.h"
#include "sim/render/scene.h"
#include "sim/view/show.h"

/* The keys and what they do, a line each. */
#define VIEW_KEYS_HELP                                                       \
    "  arrows, drag        turn\n"                                           \
    "  + -, wheel          closer, farther\n"                                \
    "  space, enter        stop or start the turning\n"                      \
    "  f g p               shading: flat, Gouraud, Phong\n"                  \
    "  t                   texture: none, nearest, bilinear\n"               \
    "  l                   light on or off (Phong has it always)\n"          \
    "  1 to 9              that light on or off\n"                           \
    "  a d s               ambient, diffuse, specular light on or off\n"     \
    "  e                   tolerance: 0, 1, 2, 4 or 8 steps of 255\n"        \
    "  m                   Phong's methods in colours (pel render --help)\n" \
    "  z                   painter's order or z-buffer\n"                    \
    "  r                   back to the start\n"                              \
    "  w                   write the picture to a file\n"                    \
    "  q, Escape           end\n"

/* The picture at a moment: settings as they were given, and changes by the user
 * since. */
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
    bool lit;     /* is there light (enum scene_lit)? Set by whoever prepares
                     the scene */
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

/* Changes the view as the key says, of enum pel_key. A key of light on a view
 * that has none brings the light, all of it that is not switched off. */
enum view_action view_key(struct view *view, int key);

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
