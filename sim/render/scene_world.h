/* From numbers for people to those of core. Only for scene*.c. */
#ifndef SIM_RENDER_SCENE_WORLD_H
#define SIM_RENDER_SCENE_WORLD_H

#include "sim/render/scene.h"

/* Places, in the scale that fits: scene->units, mesh, pose, scene.camera and
 * scene.viewport. The camera is complete. */
void scene_place(struct scene *scene, const struct scene_settings *settings);

/* Lights and material, after scene_place: lighting and light. */
void scene_place_lights(struct scene *scene,
                        const struct scene_settings *settings);

#endif
