/* From numbers for people to those of core. Only for stage*.c. */
#ifndef SIM_STAGE_WORLD_H
#define SIM_STAGE_WORLD_H

#include "stage.h"

/* Places, in the scale that fits: stage->units, mesh, pose, scene.camera and
 * scene.viewport. The camera is complete. */
void stage_place(struct stage *stage, const struct stage_settings *settings);

/* Lights and material, after stage_place: lighting and light. */
void stage_place_lights(struct stage *stage,
                        const struct stage_settings *settings);

#endif
