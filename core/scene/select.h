/* Methods that are chosen triangle by triangle, the cheapest whose error is
 * proven to be within scene->tolerance. A program links those it names; to
 * force a method, name its own object (shading.h). */
#ifndef PEL_SCENE_SELECT_H
#define PEL_SCENE_SELECT_H

#include "shading.h"

PEL_BEGIN_DECLS

/* What stands for pel_shade_phong in a triangle, the cheapest first. */
enum pel_method {
    PEL_METHOD_FLAT,    /* one color */
    PEL_METHOD_GOURAUD, /* lit at the vertices */
    PEL_METHOD_PHONG,   /* lit at every pixel */
    PEL_METHODS
};

/* pel_shade_phong to scene->tolerance: exact where that is 0. */
extern const struct pel_shading pel_shade_chosen;
PEL_END_DECLS
#endif
