/* What a stage shows, as projected triangles. */
#ifndef SIM_STAGE_PEL2D_H
#define SIM_STAGE_PEL2D_H

#include "pel2d.h"
#include "stage.h"

/* The vertices where core/scene puts them, with the colours that it gives them:
 * those of a texel for every vertex, and of light there. The depth is core's
 * number for the distance along the view. Triangles behind the near plane are
 * left out; those that reach behind it, or out of the range of sub-pixels, are
 * cut, and *clipped counts both. The stage is prepared with STAGE_GOURAUD and
 * STAGE_MAP_VERTICES. False, with a message, when memory is short; `flat` is
 * then empty. */
bool stage_project(const struct stage *stage, struct pel2d *flat,
                   uint32_t *clipped);

#endif
