/* What `pel render` and `pel import` read: a mesh file, seen by a camera, or a
 * pel2d file. */
#ifndef SIM_MESH_INPUT_H
#define SIM_MESH_INPUT_H

#include "camera.h"

struct mesh_input {
    const char *path;     /* mesh file, MESH_BUILTIN, pel2d file or "-" */
    const char *texture;  /* a file, or NULL for the mesh's own colours */
    struct camera camera; /* size and background serve pel2d files as well */
};

/* Loads, paints and projects; says on standard error how many triangles were
 * clipped. False, with a message, when something is wrong: also a camera or a
 * texture for a pel2d file, which is projected and coloured already. */
bool mesh_input_load(struct mesh_input *input, struct pel2d *flat);

#endif
