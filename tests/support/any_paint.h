/* Any paint of core. */
#ifndef TESTS_SUPPORT_ANY_PAINT_H
#define TESTS_SUPPORT_ANY_PAINT_H

#include "core/pel.h"

union any_paint {
    struct pel_paint paint;
    struct pel_flat flat;
    struct pel_gouraud gouraud;
    struct pel_color_paint colors;
    struct pel_linear linear;
    struct pel_radial radial;
    struct pel_conic conic;
    struct pel_hue_wheel wheel;
    struct pel_fan fan;
    struct pel_texture texture;
    struct pel_checker checker;
    struct pel_hatch hatch;
    struct pel_nine_slice slices;
    struct pel_dither dither;
    struct pel_blend blend;
};

#endif
