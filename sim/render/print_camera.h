/* The camera of a scene as C text, for firmware. */
#ifndef SIM_RENDER_PRINT_CAMERA_H
#define SIM_RENDER_PRINT_CAMERA_H

#include <stdio.h>

#include "sim/render/scene.h"

/* Writes an initialiser of struct pel_camera, with a comment before it, of a
 * prepared scene: with it core draws what the scene shows. */
void print_camera(FILE *out, const struct scene *scene);

#endif
