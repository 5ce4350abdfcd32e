/* The 3-D pipeline: a mesh, seen by a camera, lit, onto any surface.
 *
 *     static uint64_t scratch[2000];
 *     struct pel_mesh mesh;
 *     pel_mesh_of_asset(&mesh, &duck); // duck.c, by pel import
 *
 *     static const struct pel_light sun = {
 *         .at = {1, 2, 1}, .directional = true,
 *         .color = {PEL_FACTOR(100), PEL_FACTOR(100), PEL_FACTOR(90)}};
 *     static const struct pel_lighting lighting = {
 *         .light = &sun, .lights = 1,
 *         .ambient_color = {65536, 65536, 65536}, .ambient = PEL_FACTOR(20),
 *         .diffuse = PEL_FACTOR(70), .shininess = 1};
 *     struct pel_scene scene = {
 *         .mesh = &mesh,
 *         .camera = {.eye = {0, PEL_UNITS(1), PEL_UNITS(5)},
 *                    .up = {0, 1, 0}, .near_plane = PEL_UNITS(1) / 16,
 *                    .focal = 50, .sensor = {32, 24}},
 *         .viewport = {0, 0, 320, 240},
 *         .shading = &pel_shade_lit_gouraud, .lighting = &lighting,
 *         .sort = &pel_depth_sort, .cull = PEL_CULL_BACK};
 *     struct pel_frame frame;
 *     if (pel_scene_prepare(&frame, &scene, scratch, sizeof scratch) == PEL_OK)
 *         pel_scene_draw(&frame, &surface);
 *
 * prepare is called once for a picture, draw once for each band. A program
 * links the shadings, mappings, sort and depth buffer that it names. Triangles
 * are clipped behind the near plane and out of the range of sub-pixels. */
#ifndef PEL_SCENE_PIPELINE_H
#define PEL_SCENE_PIPELINE_H

#include "shading.h"

PEL_BEGIN_DECLS

struct pel_depth;

/* Bytes of scratch memory for a frame of the scene: 16 a vertex, 8 a triangle,
 * 40 a light, and 1,408, or 1,600 on 64-bit CPUs; for constant expressions,
 * without a sort or a shading that needs more (PEL_PERSPECTIVE_SCRATCH_SIZE),
 * and as a function: 0 without a mesh. */
#define PEL_SCENE_SCRATCH_SIZE(vertices, triangles, lights)     \
    (PEL_CAST(size_t, sizeof(void *) > 4 ? 1600 : 1408) +       \
     PEL_CAST(size_t, lights) * sizeof(struct pel_mesh_light) + \
     PEL_CAST(size_t, vertices) * 16 +                          \
     PEL_CAST(size_t, triangles) * sizeof(struct pel_depth_entry))
size_t pel_scene_scratch_size(const struct pel_scene *scene);

/* Sets up a picture: projects and lights every vertex, sorts the triangles. The
 * frame points to the scene and to the scratch memory, which is aligned to 8
 * bytes. PEL_ERROR_NULL: no scene, mesh, shading, scratch; or no lighting,
 * normals, uv, mapping or sampler where they are needed; PEL_ERROR_SCRATCH;
 * PEL_ERROR_RANGE: uv or span of a texture (mapping.h), or its number in a
 * part; errors of pel_mesh_check, pel_projector_init, pel_mesh_lights_init and
 * the sampler. frame->fault tells the triangle and index, or the part. After an
 * error a frame draws nothing. */
enum pel_status pel_scene_prepare(struct pel_frame *frame,
                                  const struct pel_scene *scene, void *scratch,
                                  size_t scratch_size);

/* Draws the frame onto the surface: the whole picture or a band or tile of it;
 * bands make the same bytes as the whole. The frame's scratch memory changes,
 * so two threads take two frames. */
void pel_scene_draw(struct pel_frame *frame, const struct pel_surface *surface);

/* The same with a depth buffer. Opaque pixels, of a part or of a texture, are
 * drawn in any order and store their depth. Translucent ones follow and are
 * only tested: they are blended in the scene's order, so set `sort`, and draw
 * such a mesh after all opaque ones. Meshes may share a buffer while camera and
 * viewport stay; for an orthographic camera a buffer serves one mesh only. */
void pel_scene_draw_depth(struct pel_frame *frame,
                          const struct pel_surface *surface,
                          const struct pel_depth *depth);
PEL_END_DECLS
#endif
