/* The paints of scripts. Only for sim/script. */
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
    SCRIPT_RAMP_COLORS = 2048, /* at most, of a gradient with stops */
    SCRIPT_STOPS_MAX = 64,
    SCRIPT_FAN_POINTS_MAX = 64
};

/* Memory for one paint, which is made anew for every shape. */
struct script_paints {
    union {
        struct pel_flat flat;
        struct pel_linear linear;
        struct pel_radial radial;
        struct pel_conic conic;
        struct pel_hue_wheel wheel;
        struct pel_fan fan;
        struct pel_texture texture;
    } paint;
    struct pel_dither dither;
    pel_color ramp[SCRIPT_RAMP_COLORS];
    struct pel_fan_triangle triangles[SCRIPT_FAN_POINTS_MAX];
};

#endif
