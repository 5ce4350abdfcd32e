#include "cases.h"

const struct atlas_case atlas_cases[] = {
    {"damage", atlas_damage},
    {"thinness", atlas_thinness},
    {"snapping", atlas_snapping},
    {"overflow", atlas_overflow},
    {"map-sliver", atlas_map_sliver},
    {"color", atlas_color},
    {"color-sliver", atlas_color_sliver},
    {"gradient", atlas_gradient},
    {"span", atlas_span},
    {"map-perspective", atlas_map_perspective},
    {"phong", atlas_phong},
    {"map-phong", atlas_map_phong},
    {"order", atlas_order},
    {"fighting", atlas_fighting},
    {NULL, NULL},
};
