/* Methods that are chosen triangle by triangle, the cheapest whose error is
 * proven to be within scene->tolerance. A program links those it names; to
 * force a method, name its own object (shading.h). */
#ifndef PEL_SCENE_SELECT_H
#define PEL_SCENE_SELECT_H

#include "shading.h"

PEL_BEGIN_DECLS

/* What stands for pel_shade_phong in a triangle. */
enum pel_method {
    PEL_METHOD_FLAT,    /* one color */
    PEL_METHOD_GOURAUD, /* lit at the vertices */
    PEL_METHOD_SPANS,   /* lit by polynomials every 2 to 8 pixels of a row */
    PEL_METHOD_QUICK,   /* lit by polynomials at every pixel */
    PEL_METHOD_PHONG,   /* lit at every pixel */
    PEL_METHODS
};

/* pel_shade_phong to scene->tolerance: exact where that is 0. Lights that can
 * add no more to any surface than a quarter of the tolerance, all together, are
 * left out of the frame. */
extern const struct pel_shading pel_shade_chosen;

/* Its `start`. */
enum pel_status pel_frame_start_chosen(struct pel_frame *frame);

/* Nearest texels instead of bilinear ones where texture->contrast
 * (texture_contrast.h), times the light, is within scene->tolerance, or half of
 * it with light; pel_shade_chosen keeps to the rest. And
 * pel_map_perspective to scene->texel_tolerance: affine, or divided every 64,
 * 32 ... 2 pixels, or at every one. With r the ratio of the largest distance to
 * the smallest and u the texels,
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

/* 16 where depths of 16 bits are proven to show what those of 32 bits do in a
 * prepared frame, or 32: of two triangles in a pixel one lies `gap` or more
 * behind the other, which the caller knows of the scene, and whole vertices are
 * seen. Triangles that touch or cross have no gap, and so have the front and
 * the back of a mesh at its outline; of a closed mesh, cull one side.
 *
 * With z and z + gap up to `far`, `first` the nearest, all of them coarse (cut
 * by less than 1), near / z of both differ by at least
 *
 *     near (gap / far^2 - 1 / first^2).
 *
 * That suffices where it is 2^-15 and a little: a step of 16 bits, and half a
 * step for each of two planes, the most by which those of triangles thinner
 * than 1/256 px are off. */
int pel_scene_depth_bits(const struct pel_frame *frame, pel_length gap);
PEL_END_DECLS
#endif
