/* The 3-D pipeline in double precision, written independently of core, from the
 * formulas of the headers. Places are in world units, pixels as they are, light
 * and colors 0..255. */
#ifndef TESTS_SUPPORT_REFERENCE_SCENE_H
#define TESTS_SUPPORT_REFERENCE_SCENE_H

#include "core/scene/pipeline.h"
#include "core/scene/mapping.h"
#include "paint_math.h"

/* The place of a vertex in the world, and its normal there, as long as it is.
 */
void reference_place(const struct pel_scene *scene, uint32_t vertex,
                     real place[3]);
void reference_normal(const struct pel_scene *scene, uint32_t vertex,
                      real normal[3]);

/* A place on screen: x and y in px, and the distance along the view. */
void reference_project(const struct pel_scene *scene, const real place[3],
                       real out[3]);

/* The nearest sub-pixel. */
struct pel_point reference_snap(const real projected[3]);

/* How much of each vertex is in the centre of a pixel: linear on screen, 1 in
 * sum. The triangle has area. */
void reference_weights(const struct pel_point v[3], int32_t x, int32_t y,
                       real weight[3]);

/* Red, green, blue of a surface at a place, lit, 0..255; a normal of any
 * length. */
void reference_light(const struct pel_scene *scene, const real place[3],
                     const real normal[3], const real surface[3], real out[3]);

/* Red, green, blue of a texture at (u, v) texels. */
void reference_texel(const struct pel_mesh_texture *texture, real u, real v,
                     bool bilinear, real out[3]);

/* u and v of a vertex, texels. */
void reference_uv(const struct pel_scene *scene, uint32_t vertex, real uv[2]);

#endif
