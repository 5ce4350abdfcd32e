/* The options of the command line that say how a model is drawn. */
#ifndef SIM_RENDER_SCENE_OPTIONS_H
#define SIM_RENDER_SCENE_OPTIONS_H

#include <argp.h>

#include "sim/cli/option_text.h"
#include "sim/render/scene.h"

/* What a command with a model takes: the file names are argv's. */
struct scene_options {
    struct scene_settings settings;
    struct model_source source; /* the path is for the command to set */
    bool has_mesh_option; /* any but those of the camera, of the source, and
                             --shade: what only a drawn mesh has */
    struct options_given given; /* all of them, and the command's own */
};

/* Lights, material, shading, texture, order, and camera_argp for where things
 * are. The input is a struct scene_options, set to its defaults before. */
extern const struct argp scene_argp;

/* Its lights and material, and its camera, with the same input. */
extern const struct argp light_argp, camera_argp;

#endif
