/* From the numbers of settings to those of core. */
#ifndef SIM_RENDER_SCENE_WORLD_H
#define SIM_RENDER_SCENE_WORLD_H

#include <stdio.h>

#include "sim/render/scene.h"

/* Places, in the scale that fits: scene->units, mesh, pose, scene.camera and
 * scene.viewport. The camera is complete. */
void scene_place(struct scene *scene, const struct scene_settings *settings);

/* Lights and material, after scene_place: lighting and light. */
void scene_place_lights(struct scene *scene,
                        const struct scene_settings *settings);

/* Writes an initialiser of struct pel_camera, with a comment before it, of a
 * prepared scene: with it core draws what the scene shows. */
void scene_print_camera(FILE *out, const struct scene *scene);

#endif
