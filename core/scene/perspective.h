/* Colors, normals and positions in perspective: linear in the world. */
#ifndef PEL_SCENE_PERSPECTIVE_H
#define PEL_SCENE_PERSPECTIVE_H

#include "divided.h"
#include "shaded.h"

PEL_BEGIN_DECLS

struct pel_shading;

/* A triangle whose values from `first` on are divided: a paint that sets the
 * values of `shaded` to those at hand, and `out` to the surface's colors, and
 * calls its function. It follows frame->work[0]. */
struct pel_divided_triangle {
    struct pel_color_paint base;
    struct pel_shaded *shaded;
    const struct pel_color_paint *surface; /* or NULL */
    struct pel_divided by;
    uint8_t first;
    struct pel_divided_value value[PEL_VALUES];
};

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
    ((sizeof(struct pel_divided_triangle) + 7) & ~PEL_CAST(size_t, 7))

/* Shadings of shading.h with colors, normals and positions as
 * they are in the world: pel_shade_gouraud, ... */
extern const struct pel_shading pel_perspective_gouraud;
extern const struct pel_shading pel_perspective_lit_gouraud;
extern const struct pel_shading pel_perspective_phong;
PEL_END_DECLS
#endif
