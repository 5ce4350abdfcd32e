/* Methods that are chosen triangle by triangle, the cheapest whose error is
 * proven to be within scene->tolerance. A program links those it names; to
 * force a method, name its own object (shading.h). */
#ifndef PEL_SCENE_SELECT_H
#define PEL_SCENE_SELECT_H

#include "mapping.h"

PEL_BEGIN_DECLS

/* What stands for pel_shade_phong in a triangle. */
enum pel_method {
    PEL_METHOD_FLAT,    /* one color */
    PEL_METHOD_GOURAUD, /* lit at the vertices */
    PEL_METHOD_PHONG,   /* lit at every pixel */
    PEL_METHODS
};

/* Shades as pel_shade_phong to scene->tolerance: exactly where that is 0. It
 * leaves lights out of the frame while all that these could add to a white
 * surface is within a quarter of the tolerance. */
extern const struct pel_shading pel_shade_chosen;

/* The same as pel_perspective_phong (perspective.h). */
extern const struct pel_shading pel_perspective_chosen;

/* Their `start`. */
enum pel_status pel_frame_start_chosen(struct pel_frame *frame);

/* Maps as pel_map_perspective to scene->texel_tolerance: affine, or divided
 * every 64, 32 ... 2 pixels, or at every one. With r the ratio of the largest
 * distance to the smallest and u the texels, the error is
 *
 *     affine   u (r - 1) / 4 or less, of a triangle;
 *     span     the same, of a span.
 *
 * (By the affine map a point is the mean of the corners' texels by weights, in
 * perspective by weights times 1 / z. If some corners have 0 and the others u
 * texels, and these have the part s of the weights, the difference is largest
 * where all of them are at one end of the distances and the others at the other
 * one: u (s r / (s r + 1 - s) - s) <= u (sqrt r - 1) / (sqrt r + 1).) */
extern const struct pel_mapping pel_map_chosen;
PEL_END_DECLS
#endif
