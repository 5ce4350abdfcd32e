/* The options of the command line that say how a model is drawn. */
#ifndef SIM_RENDER_SCENE_OPTIONS_H
#define SIM_RENDER_SCENE_OPTIONS_H

#include "sim/cli/arguments.h"
#include "sim/render/scene.h"

struct scene_options {
    struct scene_settings settings;
    struct model_source source; /* the path is for the command to set */
    struct options_given given;
};

/* Shading, camera, lights, material, texture. The input is a struct
 * scene_options, set to its defaults before. */
extern const struct option_row scene_option_table[];

#endif
