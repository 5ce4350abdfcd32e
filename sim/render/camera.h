/* The camera of the command line: what the user asked for, and what is chosen
 * for the rest. */
#ifndef SIM_RENDER_CAMERA_H
#define SIM_RENDER_CAMERA_H

#include "core/scene/camera.h"
#include "sim/mesh/model.h"

/* Names of projections, in the order of enum pel_projection. */
#define CAMERA_PROJECTIONS "perspective|orthographic"

/* The flags say what the user gave. */
struct camera {
    double eye[3], target[3], up[3]; /* world units */
    enum pel_projection projection;
    double focal;      /* mm, > 0; perspective */
    double sensor[2];  /* width and height, > 0: mm, or of what is seen in world
                          units when orthographic */
    double near_plane; /* world units, > 0: nothing nearer is seen */
    int width, height; /* px of the picture, 1..32,767 */
    pel_color background;
    bool has_eye, has_target, has_sensor, has_near;
};

/* Fills in what was left open, from the model: the target is the middle of its
 * box; the eye stands in front, a little to the right and above, as near as
 * shows every vertex with a margin of 1/20; pixels are square; the near plane
 * is close before the model however it is turned around its middle, but at
 * 1/1000 of the distance from eye to target at least. False, with a message on
 * standard error, when eye and target are the same or `up` points along the
 * view. The flags stay: set them to keep what was found. */
bool camera_frame(struct camera *camera, const struct model *model);

#endif
