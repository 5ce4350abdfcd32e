/* The paints of scripts. Only for script*.c. */
#ifndef SIM_SCRIPT_PAINTS_H
#define SIM_SCRIPT_PAINTS_H

#include "core/paint/paint_dither.h"
#include "core/paint/paint_fan.h"
#include "core/paint/paint_hue.h"
#include "core/paint/paint_linear.h"
#include "core/paint/paint_radial.h"
#include "core/paint/paint_texture.h"
#include "sim/script/commands.h"

enum {
    SCRIPT_RAMP_COLORS = 2048, /* of a gradient with stops */
    SCRIPT_STOPS_MAX = 64,
    SCRIPT_FAN_POINTS_MAX = 64
};

/* Memory for one paint, which is made anew for every shape. */
struct script_paints {
    union {
        struct pel_linear linear;
        struct pel_radial radial;
        struct pel_conic conic;
        struct pel_hue_wheel wheel;
        struct pel_fan fan;
        struct pel_texture texture;
    } paint;
    struct pel_dither dither;
    pel_color ramp[SCRIPT_RAMP_COLORS];
    struct pel_fan_wedge wedges[SCRIPT_FAN_POINTS_MAX];
};

/* The paint that the pen's values describe, in the pen's memory. */
script_make_paint script_make_linear, script_make_linear_stops,
    script_make_radial, script_make_conic, script_make_wheel, script_make_fan,
    script_make_texture, script_make_texture_map;

/* Do the pen's values describe a fan? */
bool script_fan_legal(const struct script_pen *pen);

#endif
