/* The triangles of a scene, projected. */
#ifndef SIM_RENDER_SCENE_PEL2D_H
#define SIM_RENDER_SCENE_PEL2D_H

#include "sim/mesh/pel2d.h"
#include "sim/render/scene.h"

/* The vertices where core/scene puts them, with the colors that it gives them:
 * those of a texel for every vertex, and of light there. The depth is core's
 * number for the distance along the view. Triangles behind the near plane are
 * left out; those that cross it, or out of the range of sub-pixels, are
 * cut, and *clipped counts both. The scene is prepared with SCENE_GOURAUD and
 * SCENE_MAP_VERTICES. False, with a message, when memory is short; `flat` is
 * then empty. */
bool scene_project(const struct scene *scene, struct pel2d *flat,
                   uint32_t *clipped);

#endif
