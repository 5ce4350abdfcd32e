/* Colors, normals and positions in perspective: linear in the world. */
#ifndef PEL_SCENE_PERSPECTIVE_H
#define PEL_SCENE_PERSPECTIVE_H

#include "shading.h"

PEL_BEGIN_DECLS

/* Where values lie between vertices: their paints of colors at the vertices and
 * of light at pixels, and what these may be off by, 1/256 step. */
struct pel_interpolation {
    pel_shade_function *gouraud, *phong;
    int32_t error;
};

/* In the world. Colors alone are divided every 8 pixels, or at every one where
 * they would be off by more than 1/4 step between; with normals and positions
 * all are divided at every one, as light near a lamp shows the least change of
 * a position. Where the distances of a triangle's corners are so near to each
 * other that colors which are linear on screen are within 1/4 step, they are.
 */
extern const struct pel_interpolation pel_in_world;

/* Bytes of scratch memory that the shadings below take besides
 * PEL_SCENE_SCRATCH_SIZE. */
#define PEL_PERSPECTIVE_SCRATCH_SIZE \
    PEL_CAST(size_t, sizeof(void *) > 4 ? 464 : 440)

/* pel_shade_gouraud, pel_shade_lit_gouraud and pel_shade_phong, with colors,
 * normals and positions as they are in the world. */
extern const struct pel_shading pel_perspective_gouraud;
extern const struct pel_shading pel_perspective_lit_gouraud;
extern const struct pel_shading pel_perspective_phong;
PEL_END_DECLS
#endif
