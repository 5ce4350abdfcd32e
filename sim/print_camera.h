/* The camera of a stage as C text, for firmware. */
#ifndef SIM_PRINT_CAMERA_H
#define SIM_PRINT_CAMERA_H

#include <stdio.h>

#include "stage.h"

/* Writes an initialiser of struct pel_camera, with a comment before it, of a
 * prepared stage: with it core draws what the stage shows. */
void print_camera(FILE *out, const struct stage *stage);

#endif
