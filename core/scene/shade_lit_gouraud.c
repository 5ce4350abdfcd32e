#include "shading.h"

const struct pel_shading pel_shade_lit_gouraud = {
    pel_shade_start_light, pel_shade_light_vertex, pel_shade_gouraud_paint};
