#include "cases.h"

const struct atlas_case atlas_cases[] = {
    {"damage", atlas_damage},
    {NULL, NULL},
};
