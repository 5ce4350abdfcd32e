#include "cases.h"

const struct atlas_case atlas_cases[] = {
    {"damage", atlas_damage},         {"thinness", atlas_thinness},
    {"snapping", atlas_snapping},     {"overflow", atlas_overflow},
    {"map-sliver", atlas_map_sliver}, {NULL, NULL},
};
