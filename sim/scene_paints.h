/* The paints of scene scripts. Only for scene*.c. */
#ifndef SIM_SCENE_PAINTS_H
#define SIM_SCENE_PAINTS_H

#include "core/paint/paint_dither.h"
#include "core/paint/paint_fan.h"
#include "core/paint/paint_hue.h"
#include "core/paint/paint_linear.h"
#include "core/paint/paint_radial.h"
#include "core/paint/paint_texture.h"
#include "scene_commands.h"

enum {
    SCENE_RAMP_COLORS = 2048, /* of a gradient with stops */
    SCENE_STOPS_MAX = 64,
    SCENE_FAN_POINTS_MAX = 64
};

/* Memory for one paint, which is made anew for every shape. */
struct scene_paints {
    union {
        struct pel_linear linear;
        struct pel_radial radial;
        struct pel_conic conic;
        struct pel_hue_wheel wheel;
        struct pel_fan fan;
        struct pel_texture texture;
    } paint;
    struct pel_dither dither;
    pel_color ramp[SCENE_RAMP_COLORS];
    struct pel_fan_wedge wedges[SCENE_FAN_POINTS_MAX];
};

/* The paint that the pen's values describe, in the pen's memory. */
scene_make_paint scene_make_linear, scene_make_linear_stops, scene_make_radial,
    scene_make_conic, scene_make_wheel, scene_make_fan, scene_make_texture,
    scene_make_texture_map;

/* Do the pen's values describe a fan? */
bool scene_fan_legal(const struct scene_pen *pen);

#endif
